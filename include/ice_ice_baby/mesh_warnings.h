// Warnings about meshes that are not the surface of a solid.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// One line for each mesh that is open or whose triangles do not all face the same way: what that
/// means, and where.
std::vector<std::string> meshWarnings(const Scene& scene);

}  // namespace ice_ice_baby
