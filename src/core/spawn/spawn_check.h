// Where water may not begin.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Refuses a block of which a particle has its centre within a collider, one that reaches through
/// the walls of a closed container, one of which `carve` leaves nothing, and two blocks whose
/// particles lie within each other. What only comes nearer to a collider than half a spacing is
/// pushed out of it before the first frame. Refuses a source of which a particle would start within
/// a collider in the same way, and a floating solid that reaches into a collider, into water or
/// into another solid.
/// @throws InvalidInput that names the keys and says how many particles are concerned
void requireFreeSpawn(const Scene& scene);

}  // namespace ice_ice_baby
