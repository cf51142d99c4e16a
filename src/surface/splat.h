// Adds the kernels of particles to the nodes of a block.
#pragma once

#include "smoothed_volume.h"

namespace ice_ice_baby {

struct Splat {
  const std::vector<Vec3<float>>& positions;
  const std::vector<float>& weights;  ///< of the particles
  float edge_m;                       ///< distance of the nodes
  float reach_m;                      ///< of the kernel
};

/// Sets the values of a block to the sum of weight (1 - r^2 / reach^2)^3 over its members.
void splat(const Splat& particles, SmoothedVolume::Block& block);

}  // namespace ice_ice_baby
