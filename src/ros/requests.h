// Service requests as arguments of the core.
#pragma once

#include <ice_ice_baby/HeatRegion.h>

#include <string>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// @throws InvalidInput for an unknown name or a path; only the operator of the node may choose
/// files, not the caller of a service
void requireSceneName(const std::string& name);

/// Does not check the numbers. @throws InvalidInput for any shape but box and sphere
HeatedRegion regionOf(const HeatRegion::Request& request);

}  // namespace ice_ice_baby
