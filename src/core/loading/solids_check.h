// Checks of the floating solids of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Refuses more than kMaxSolids solids, names that a collider, a gauge or another solid has, shapes
/// that are too small for the spacing of the particles, densities too far from that of the water,
/// solids beyond the bounds of the scene, and those that start too fast.
/// @throws InvalidInput
void requireSolids(const Scene& scene);

}  // namespace ice_ice_baby
