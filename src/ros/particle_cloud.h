// Particles as a point cloud.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Writes `samples` into `cloud`, one point each: x y z [m], vx vy vz [m/s], temperature [degrees
/// C], ice_fraction, density [rest density] as FLOAT32, id as UINT32, and with `rgb` a packed
/// 0x00RRGGBB as FLOAT32, as PCL has it: 40 bytes per point, or 44. Not `rgba`: rviz draws a cloud
/// that has it without depth, so that what is behind covers what is before. Reuses the memory of
/// `cloud`; its header stays.
void writeCloud(const std::vector<ParticleSample>& samples, bool rgb,
                sensor_msgs::PointCloud2& cloud);

/// Colour of a particle, 0x00RRGGBB: water is blue, ice nearly white.
std::uint32_t particleColour(float ice_fraction);

}  // namespace ice_ice_baby
