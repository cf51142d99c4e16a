#include "particle_colour.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr Colour kWater{0.13f, 0.46f, 0.86f};

struct Stop {
  float celsius;
  Colour colour;
};
constexpr Stop kStops[] = {{0.0f, {0.04f, 0.16f, 0.56f}},
                           {20.0f, kWater},
                           {60.0f, {0.56f, 0.40f, 0.72f}},
                           {100.0f, {0.90f, 0.33f, 0.24f}}};

std::uint32_t packed(Colour colour) {
  const auto byte = [](float part) { return static_cast<std::uint32_t>(std::lround(255 * part)); };
  return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

}  // namespace

Colour mixed(Colour a, Colour b, float share) {
  const float s = std::min(std::max(share, 0.0f), 1.0f);
  return {a.red + s * (b.red - a.red), a.green + s * (b.green - a.green),
          a.blue + s * (b.blue - a.blue)};
}

Colour unpacked(std::uint32_t colour) {
  const auto part = [colour](int shift) {
    return static_cast<float>(colour >> shift & 255u) / 255.0f;
  };
  return {part(16), part(8), part(0)};
}

Colour waterColour(float celsius) {
  Colour colour = kStops[0].colour;
  for (std::size_t k = 1; k < std::size(kStops); ++k) {
    const float past = celsius - kStops[k - 1].celsius;
    if (past <= 0.0f) break;
    colour = mixed(kStops[k - 1].colour, kStops[k].colour,
                   past / (kStops[k].celsius - kStops[k - 1].celsius));
  }
  return colour;
}

float whiteness(const ParticleSample& sample) {
  return 0.5f * (sample.ice_fraction + (sample.phase == Phase::kIce ? 1.0f : 0.0f));
}

std::uint32_t particleColour(float ice_fraction) {
  return packed(mixed(kWater, kIceColour, ice_fraction));
}

std::uint32_t solidColour() { return packed(kSolidColour); }

std::uint32_t heatColour(const ParticleSample& sample) {
  if (sample.phase == Phase::kSolid) return solidColour();
  if (sample.phase == Phase::kSteam) return packed(kSteamColour);
  return packed(mixed(waterColour(sample.temperature_c), kIceColour, whiteness(sample)));
}

std::uint32_t surfaceColour(Phase phase, bool thermal, float celsius, float ice_fraction) {
  if (!thermal) return particleColour(ice_fraction);
  ParticleSample sample{};
  sample.phase = phase;
  sample.temperature_c = celsius;
  sample.ice_fraction = ice_fraction;
  return heatColour(sample);
}

}  // namespace ice_ice_baby
