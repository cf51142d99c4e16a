// Validates the gauges of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Refuses more than kMaxGauges gauges, names that are taken or unfit, and frames that are no
/// collider of the scene.
/// @throws InvalidInput that names the key
void requireGauges(const Scene& scene);

}  // namespace ice_ice_baby
