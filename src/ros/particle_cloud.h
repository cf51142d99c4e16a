// Particles as a point cloud.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Writes `samples` into `cloud`, one point each: x y z [m], vx vy vz [m/s], temperature [degrees
/// C], ice_fraction, density [rest density] as FLOAT32, id as UINT32, and with `rgba` a packed
/// 0xAARRGGBB as UINT32: 40 bytes per point, or 44. Reuses the memory of `cloud`; its header stays.
void writeCloud(const std::vector<ParticleSample>& samples, bool rgba,
                sensor_msgs::PointCloud2& cloud);

/// Colour of a particle, 0xAARRGGBB: water is translucent blue, ice nearly white and opaque.
std::uint32_t particleColour(float ice_fraction);

}  // namespace ice_ice_baby
