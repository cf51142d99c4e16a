// Volumes of the particles of a solid.
#pragma once

#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Volume of each particle of a solid relative to that of water at rest, in the order of
/// forEachSolidPoint. They sum to filledVolume_m3. Layers that curve are packed unevenly; where
/// they are denser than water at rest, their particles are made smaller, because the solid would
/// press on the water beside it for ever.
std::vector<double> solidVolumes(const Scene& scene, const Solid& solid);

}  // namespace ice_ice_baby
