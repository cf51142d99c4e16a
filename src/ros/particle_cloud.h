// Particles as a point cloud.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// How points are coloured: not at all, by ice_fraction, or as heatColour has it.
enum class Colouring { kPlain, kScene, kHeat };

/// Writes `samples` into `cloud`, one point each: x y z [m], vx vy vz [m/s], temperature [degrees
/// C], ice_fraction, density [rest density] and pressure [Pa] as FLOAT32, id as UINT32, phase (0
/// water, 1 ice, 2 steam, 3 solid) as UINT8, and but for kPlain `rgb`, a packed 0x00RRGGBB as
/// FLOAT32, as PCL has it: 48 bytes per point, or 52. Not `rgba`: rviz draws a cloud that has it
/// without depth, so that what is behind covers what is in front. Reuses the memory of `cloud`; its
/// header stays.
void writeCloud(const std::vector<ParticleSample>& samples, Colouring colouring,
                sensor_msgs::PointCloud2& cloud);

}  // namespace ice_ice_baby
