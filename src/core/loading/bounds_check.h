// Validates the bounds of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Refuses bounds without volume, and blocks that reach beyond the bounds.
/// @throws InvalidInput that names the keys
void requireBounds(const Scene& scene);

}  // namespace ice_ice_baby
