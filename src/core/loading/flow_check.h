// Validates the sources and drains of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Checks names, directions, speeds, temperatures and extents, but not solids, for which
/// requireFreeSpawn checks.
/// @throws InvalidInput that names the source or drain, the value and the cure
void requireFlow(const Scene& scene);

}  // namespace ice_ice_baby
