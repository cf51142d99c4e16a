#include "particle_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace ice_ice_baby {
namespace {

int red(std::uint32_t colour) { return static_cast<int>(colour >> 16 & 255u); }
int blue(std::uint32_t colour) { return static_cast<int>(colour & 255u); }

ParticleSample waterAt(float celsius) {
  ParticleSample sample{};
  sample.density = 1.0f;
  sample.temperature_c = celsius;
  return sample;
}

TEST(ParticleColourTest, MixingHoldsTheShareBetweenBothColours) {
  const Colour a{0.2f, 0.4f, 0.6f}, b{0.4f, 0.8f, 0.2f};
  EXPECT_FLOAT_EQ(mixed(a, b, 0.25f).red, 0.25f);
  EXPECT_FLOAT_EQ(mixed(a, b, 0.25f).green, 0.5f);
  EXPECT_FLOAT_EQ(mixed(a, b, 0.25f).blue, 0.5f);
  EXPECT_EQ(mixed(a, b, -3.0f).red, a.red);
  EXPECT_FLOAT_EQ(mixed(a, b, 3.0f).blue, b.blue);
}

TEST(ParticleColourTest, WaterGoesFromBlueToRedWithoutAStep) {
  int redness = red(heatColour(waterAt(-5.0f))) - blue(heatColour(waterAt(-5.0f)));
  for (float celsius = -5.0f; celsius <= 105.0f; celsius += 0.25f) {
    const std::uint32_t colour = heatColour(waterAt(celsius));
    const int next = red(colour) - blue(colour);
    EXPECT_LE(std::abs(next - redness), 4) << celsius;
    redness = next;
  }
  EXPECT_EQ(heatColour(waterAt(-5.0f)), heatColour(waterAt(0.0f)));
  EXPECT_EQ(heatColour(waterAt(105.0f)), heatColour(waterAt(100.0f)));
  EXPECT_LT(red(heatColour(waterAt(0.0f))), blue(heatColour(waterAt(0.0f))));
  EXPECT_GT(red(heatColour(waterAt(100.0f))), blue(heatColour(waterAt(100.0f))));
}

TEST(ParticleColourTest, AtTwentyDegreesHeatChangesNoColour) {
  ParticleSample sample = waterAt(20.0f);
  EXPECT_EQ(heatColour(sample), particleColour(0.0f));
  sample.ice_fraction = 1.0f;
  sample.phase = Phase::kIce;
  EXPECT_EQ(heatColour(sample), particleColour(1.0f));
}

TEST(ParticleColourTest, SlushThatFlowsIsWaterWithIceInIt) {
  ParticleSample slush = waterAt(0.0f), melting = waterAt(0.0f), ice = waterAt(0.0f);
  slush.ice_fraction = melting.ice_fraction = 0.6f;
  ice.ice_fraction = 1.0f;
  melting.phase = ice.phase = Phase::kIce;
  EXPECT_FLOAT_EQ(whiteness(slush), 0.3f);
  EXPECT_FLOAT_EQ(whiteness(melting), 0.8f);
  EXPECT_LT(red(heatColour(waterAt(0.0f))), red(heatColour(slush)));
  EXPECT_LT(red(heatColour(slush)), red(heatColour(melting)));
  EXPECT_LT(red(heatColour(melting)), red(heatColour(ice)));
}

TEST(ParticleColourTest, TheColourTellsWaterFromIceWhateverIsFrozenOfThem) {
  for (float fraction = 0.0f; fraction <= 1.0f; fraction += 0.125f) {
    ParticleSample sample = waterAt(0.0f);
    sample.ice_fraction = fraction;
    EXPECT_LE(whiteness(sample), 0.5f);
    sample.phase = Phase::kIce;
    EXPECT_GE(whiteness(sample), 0.5f);
  }
}

TEST(ParticleColourTest, SteamIsGreyHoweverHotAndDense) {
  ParticleSample sample = waterAt(100.0f);
  sample.phase = Phase::kSteam;
  const std::uint32_t steam = heatColour(sample);
  EXPECT_EQ(red(steam), std::lround(255 * kSteamColour.red));
  EXPECT_EQ(blue(steam), std::lround(255 * kSteamColour.blue));
  sample.temperature_c = 300.0f;
  EXPECT_EQ(heatColour(sample), steam);
  ParticleSample thin = waterAt(20.0f);
  thin.density = 0.0f;
  EXPECT_EQ(heatColour(thin), heatColour(waterAt(20.0f))) << "a lone drop is no steam";
}

}  // namespace
}  // namespace ice_ice_baby
