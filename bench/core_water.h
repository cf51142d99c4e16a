// Settled water in the solver's own arrays.
#pragma once

#include "particles/neighbours.h"
#include "particles/particles.h"
#include "settled_water.h"

namespace ice_ice_baby::bench {

constexpr float kSpacing_m = 0.02f;
constexpr float kSupport_m = 2 * kSpacing_m;
constexpr float kSkin_m = 0.3f * kSpacing_m;  ///< as the simulator has it

/// Settled water with lists of neighbours, at rest.
struct CoreWater {
  explicit CoreWater(std::size_t count);

  Particles<float> particles;
  Neighbours<float> neighbours;
};

}  // namespace ice_ice_baby::bench
