// Whether a scene fits this machine, told before memory is taken: the kernel would give it out
// first and end the program later.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Memory that a particle takes at the least, lists of neighbours included: what the stages of the
/// leanest scenes hold is a little more.
constexpr double kLeastParticle_bytes = 200.0;

/// @throws InvalidInput for a scene whose particles take more than `memory_bytes`
void requireMemory(const Scene& scene, double memory_bytes);

}  // namespace ice_ice_baby
