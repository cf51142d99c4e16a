// Validates the heat regions of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// @throws InvalidInput for heat regions of a scene without heat, without power, of another shape
/// than box or sphere, with the same name, and for more than kMaxHeatRegions
void requireHeatRegions(const Scene& scene);

}  // namespace ice_ice_baby
