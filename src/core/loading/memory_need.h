// Checks that a scene fits into memory before allocating: Linux would grant the memory and kill the
// program later.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Lower bound of the memory per particle, neighbour lists included. The smallest scenes use
/// slightly more.
constexpr double kMinParticle_bytes = 200.0;

/// @throws InvalidInput for a scene whose particles take more than `memory_bytes`
void requireMemory(const Scene& scene, double memory_bytes);

}  // namespace ice_ice_baby
