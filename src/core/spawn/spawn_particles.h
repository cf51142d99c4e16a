// The particles of a scene at the start.
#pragma once

#include "particles/particles.h"

namespace ice_ice_baby {

/// Fills every block of the scene, then every solid, in the order of the scene file.
/// @param spawns one entry per block and one per solid
template <class Real>
Particles<Real> spawnParticles(const Scene& scene, std::vector<Spawn>& spawns);

}  // namespace ice_ice_baby
