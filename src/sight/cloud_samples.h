// Particles from the point cloud of a simulation.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "ice_ice_baby/samples.h"

namespace ice_ice_baby {

/// What `~particles` says of each particle; see doc/ros_interface.md for the fields.
/// @throws InvalidInput for a cloud that lacks a field, has fewer bytes than it says or an unknown
/// phase
std::vector<ParticleSample> readSamples(const sensor_msgs::PointCloud2& cloud);

}  // namespace ice_ice_baby
