// What a service request asks for, in the words of the core.
#pragma once

#include <ice_ice_baby/HeatRegion.h>

#include <string>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// @throws InvalidInput for a path as for an unknown name: files are the operator's to choose, not
/// those of whoever reaches the service
void requireSceneName(const std::string& name);

/// @throws InvalidInput for a shape that no heated region has; the numbers are not checked
HeatedRegion regionOf(const HeatRegion::Request& request);

}  // namespace ice_ice_baby
