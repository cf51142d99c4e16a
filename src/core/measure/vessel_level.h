// How high a volume of water stands in a vessel.
#pragma once

#include <functional>

#include "measure/vessel_space.h"

namespace ice_ice_baby {

/// Height of the surface at rest above the lowest point of the space, m: the space below it that
/// nothing else takes has that volume. What does not fit stands as high as the space.
/// @param up unit vector against gravity, in the frame of the space
/// @param taken whether a point in that frame lies in something that displaces water; empty: none
/// does
double levelOf_m(const VesselSpace& space, const Vec3d& up, double volume_m3,
                 const std::function<bool(const Vec3d&)>& taken);

}  // namespace ice_ice_baby
