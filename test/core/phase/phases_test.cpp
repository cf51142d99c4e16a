// Which particles are water, ice and steam, and what the solver learns of it.
#include "phase/phases.h"

#include <gtest/gtest.h>

#include <limits>

#include "fixtures.h"
#include "ice/springs.h"

namespace ice_ice_baby {
namespace phases_test {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();

class PhasesTest : public ::testing::Test {
 protected:
  PhasesTest() { scene_.thermal.enabled = true; }

  EnthalpyCurve curve() const { return EnthalpyCurve(scene_.thermal); }
  /// Updates the phases and lets volumes reach their final value.
  template <class Real>
  void settle(Phases<Real>& phases, const std::vector<double>& enthalpy) const {
    phases.update(curve(), enthalpy);
    phases.swell(kAtOnce);
    phases.update(curve(), enthalpy);
  }
  Scene scene_;
};

TEST_F(PhasesTest, FreezesAndMeltsWithHysteresis) {
  Phases<float> phases(scene_, 1);
  const auto at = [&](double celsius) {
    settle(phases, {curve().enthalpy(celsius)});
    return phases.of(0);
  };
  EXPECT_EQ(at(5.0), Phase::kWater);
  EXPECT_EQ(at(-0.1), Phase::kWater) << "supercooled by less than the hysteresis";
  EXPECT_EQ(at(-0.3), Phase::kIce);
  EXPECT_EQ(at(-0.1), Phase::kIce);
  EXPECT_EQ(at(0.1), Phase::kIce) << "superheated by less than the hysteresis";
  EXPECT_EQ(at(0.3), Phase::kWater);
}

TEST_F(PhasesTest, BoilsOnceTheLatentHeatIsAbsorbedAndCondensesOnceItIsReleased) {
  Phases<float> phases(scene_, 1);
  const double boils = curve().enthalpy(100.0);
  const auto at = [&](double enthalpy) {
    settle(phases, {enthalpy});
    return phases.of(0);
  };
  EXPECT_EQ(at(boils + 0.99 * scene_.thermal.latent_heat_vaporisation_j_kg), Phase::kWater);
  EXPECT_EQ(at(boils + 1.01 * scene_.thermal.latent_heat_vaporisation_j_kg), Phase::kSteam);
  EXPECT_EQ(phases.relativeVolume()[0], 0.0f);
  EXPECT_EQ(at(boils + 0.01 * scene_.thermal.latent_heat_vaporisation_j_kg), Phase::kSteam);
  EXPECT_EQ(at(boils - 1.0), Phase::kWater);
}

TEST_F(PhasesTest, WaterSwellsInHalfASecondAndIsIceOnlyThen) {
  Phases<double> phases(scene_, 1);
  const double expansion = 1 / scene_.ice.density_ratio - 1;
  settle(phases, {scene_.thermal.latent_heat_fusion_j_kg / 2});
  EXPECT_NEAR(phases.relativeVolume()[0], 1 + expansion / 2, 1e-12);
  EXPECT_NEAR(phases.slush()[0], 0.5, 1e-12);
  phases.update(curve(), {curve().enthalpy(-20.0)});
  for (int k = 0; k < 5; ++k) phases.swell(0.01);
  phases.update(curve(), {curve().enthalpy(-20.0)});
  EXPECT_NEAR(phases.relativeVolume()[0], 1 + expansion * 0.6, 1e-12);
  EXPECT_EQ(phases.of(0), Phase::kWater);
  EXPECT_EQ(phases.slush()[0], 1.0);
  phases.swell(0.3);
  phases.update(curve(), {curve().enthalpy(-20.0)});
  EXPECT_EQ(phases.of(0), Phase::kIce);
  EXPECT_EQ(phases.slush()[0], 0.0) << "it flows no more";
}

TEST_F(PhasesTest, CondensingSteamSwellsFromNoVolume) {
  Phases<double> phases(scene_, 1);
  settle(phases, {curve().enthalpy(200.0)});
  ASSERT_EQ(phases.relativeVolume()[0], 0.0);
  phases.update(curve(), {curve().enthalpy(50.0)});
  phases.swell(0.1);
  EXPECT_NEAR(phases.relativeVolume()[0], 0.2, 1e-12);
}

/// A row of five particles a spacing apart: water, ice, ice, water, steam.
class RowTest : public PhasesTest {
 protected:
  RowTest() : cloud_(points(), 0.1, 0.01), phases_(scene_, 5) {
    std::vector<double> enthalpy;
    for (const std::uint32_t id : cloud_.particles.id) {
      const bool ice = id == 1 || id == 2;
      enthalpy.push_back(curve().enthalpy(ice ? -5.0 : id == 4 ? 200.0 : 5.0));
    }
    settle(phases_, enthalpy);
  }

  static std::vector<Vec3d> points() {
    std::vector<Vec3d> row;
    for (int k = 0; k < 5; ++k) row.emplace_back(0.06 * k, 0, 0);
    return row;
  }
  Index placeOf(std::uint32_t id) const {
    const auto& ids = cloud_.particles.id;
    return static_cast<Index>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  }

  test::Cloud<double> cloud_;
  Phases<double> phases_;
};

TEST_F(RowTest, OnlyIceBesideWaterIsWet) {
  phases_.findWet(cloud_.neighbours);
  EXPECT_TRUE(phases_.wet()[placeOf(1)]);
  EXPECT_TRUE(phases_.wet()[placeOf(3)]);
  EXPECT_FALSE(phases_.wet()[placeOf(4)]) << "steam";
  EXPECT_FALSE(phases_.flows()[placeOf(2)]);
  EXPECT_TRUE(phases_.pressed()[placeOf(2)]) << "ice beside ice beside water";
}

TEST_F(RowTest, SpringsJoinIceAndLabelItsBodies) {
  Springs<double> springs(scene_.springs);
  springs.freeze(cloud_.particles, cloud_.neighbours, phases_, 0.1);
  ASSERT_EQ(springs.size(), 1u);
  std::vector<Index> labels;
  springs.labelBodies(phases_, labels);
  EXPECT_EQ(labels[placeOf(1)], labels[placeOf(2)]);
  EXPECT_NE(labels[placeOf(1)], kNone);
  EXPECT_EQ(labels[placeOf(0)], kNone);
  std::vector<double> melted(5, curve().enthalpy(5.0));
  settle(phases_, melted);
  springs.breakMelted(phases_);
  EXPECT_TRUE(springs.empty());
}

}  // namespace phases_test
}  // namespace ice_ice_baby
