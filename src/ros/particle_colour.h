// Colours of particles, packed as 0x00RRGGBB.
#pragma once

#include <cstdint>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Without heat: water is blue, ice nearly white.
std::uint32_t particleColour(float ice_fraction);

/// With heat: water goes from deep blue at 0 degrees C over the usual blue at 20 to red at 100, ice
/// is nearly white by its fraction, steam light grey.
std::uint32_t heatColour(const ParticleSample& sample);

}  // namespace ice_ice_baby
