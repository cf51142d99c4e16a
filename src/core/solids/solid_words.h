// How messages call a solid.
#pragma once

#include <string>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/solid_params.h"

namespace ice_ice_baby {

/// "solids.0 (ball)". @param k its number in the scene
inline std::string solidWords(const Solid& solid, std::size_t k) {
  const std::string key = "solids." + std::to_string(k);
  return solid.name.empty() ? key : key + " (" + shortened(solid.name) + ")";
}

}  // namespace ice_ice_baby
