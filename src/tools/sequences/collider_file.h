// The colliders of a scene as a file that other programs draw beside its surfaces.
#pragma once

#include <string>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Wavefront OBJ with an object for each collider where it is now. Its material is `glass`,
/// `ground` or `object`, and `hidden` where the scene says that its opacity is 0.
/// @throws InvalidInput if the file cannot be written
void writeColliders(const std::string& path, const Simulation& simulation);

/// The same for floating solids, with the material `solid`.
void writeSolids(const std::string& path, const Simulation& simulation);

}  // namespace ice_ice_baby
