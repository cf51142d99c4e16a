// Colours of particles, for point clouds and for pictures.
#pragma once

#include <cstdint>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Parts from 0 to 1.
struct Colour {
  float red, green, blue;
};

constexpr Colour kIceColour{0.90f, 0.96f, 1.0f};
constexpr Colour kSteamColour{0.86f, 0.87f, 0.89f};
constexpr Colour kSolidColour{0.80f, 0.52f, 0.28f};

/// @param share of `b`, held within [0, 1]
Colour mixed(Colour a, Colour b, float share);

/// Of a packed 0x00RRGGBB.
Colour unpacked(std::uint32_t colour);

/// From deep blue at 0 degrees C over the usual blue at 20 to red at 100.
Colour waterColour(float celsius);

/// Share of ice in the colour of a particle, 0 ... 1: the colour tells whether it flows. Water is 0
/// to 1/2 by the ice in it, ice 1/2 to 1 by what of it has not melted yet.
float whiteness(const ParticleSample& sample);

/// Without heat: water is blue, ice nearly white, in between by the strictness of the springs.
/// Packed as 0x00RRGGBB.
std::uint32_t particleColour(float ice_fraction);

/// Of floating solids, packed as 0x00RRGGBB.
std::uint32_t solidColour();

/// With heat: water by its temperature, ice nearly white, both mixed by `whiteness`, steam light
/// grey, floating solids brown. Packed as 0x00RRGGBB.
std::uint32_t heatColour(const ParticleSample& sample);

/// Of a place on the surface of `phase`: as a particle there. @param thermal whether there is heat
std::uint32_t surfaceColour(Phase phase, bool thermal, float celsius, float ice_fraction);

}  // namespace ice_ice_baby
