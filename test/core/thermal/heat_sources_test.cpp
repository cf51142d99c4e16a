// Heat from air and heated regions, for water and for steam.
#include <gtest/gtest.h>

#include <cstdio>

#include "thermal/thermal_fixture.h"

namespace ice_ice_baby {
namespace heat_sources_test {

using test::StillHeat;
using test::warmCube;

/// Area measured by the heat that slightly warmer air brings in a second, at so small a transfer
/// coefficient that conduction in the water does not matter.
double bareArea_m2(Scene scene) {
  scene.thermal.air_heat_transfer_w_m2k = 1e-3;
  StillHeat<double> still(scene);
  still.run(1.0, scene.blocks[0].celsius + 1.0);
  return still.heat.heatIn_j() / 1e-3;
}

/// Edges count as rounded, so the area is too small by an error of the order of the spacing.
TEST(HeatSourcesTest, CubeIsBareOnItsSixSides) {
  for (const int n : {6, 12}) {
    const double share = bareArea_m2(warmCube(n, 20.0)) / (6 * std::pow(0.02 * n, 2));
    std::printf("bare area of %d^3 particles: %.3f of its sides\n", n, share);
    EXPECT_NEAR(share, 1.0, 1.6 / n);
  }
}

/// The walls rise above the water and so cover a little of the particles next to them.
TEST(HeatSourcesTest, WallsKeepTheAirAway) {
  Scene scene = warmCube(8, 20.0);
  scene.blocks[0] = test::blockOf({-0.08, -0.08, 0}, {0.08, 0.08, 0.16});
  scene.containers.push_back(test::tankOf(Vec3d::Constant(0.16), true));
  EXPECT_NEAR(bareArea_m2(scene) / (0.16 * 0.16), 1.0, 0.1);
  scene.containers[0].open_top = false;
  EXPECT_EQ(bareArea_m2(scene), 0.0);
}

TEST(HeatSourcesTest, ASmallBlockCoolsInAirLikeALump) {
  Scene scene = warmCube(6, 80.0);
  scene.thermal.air_heat_transfer_w_m2k = 0.1;
  const double area = bareArea_m2(scene);
  const double mass = 216 * particleMass_kg(scene.fluid, scene.supportRadius_m());
  const double half_life_s = std::log(2) * mass * 4186 / (0.1 * area);
  scene.thermal.speedup = half_life_s;
  StillHeat<double> still(scene);
  still.run(half_life_s, 20.0);
  const double kelvin = still.heat.totalEnthalpy_j() / mass - 334e3;
  EXPECT_NEAR(kelvin / 4186, 50.0, 0.3);
}

TEST(HeatSourcesTest, ARegionHeatsWhatIsInItAndEnds) {
  Scene scene = warmCube(8, 20.0);
  scene.thermal.water_conductivity_w_mk = 0.0;
  scene.thermal.speedup = 2.0;
  StillHeat<double> still(scene);
  still.heat.addRegion({BlockShape::kBox, {0, 0, 0}, Vec3d::Constant(0.16), 100.0, 0.505});
  EXPECT_EQ(still.heat.regions(), 1u);
  still.run(4.0);
  EXPECT_EQ(still.heat.regions(), 0u);
  EXPECT_NEAR(still.heat.heatIn_j(), 100.0 * 0.505 * 2, 1e-3);
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const bool inside = still.particles.position.at(i).maxCoeff() < 0.08;
    EXPECT_EQ(still.heat.temperature(i) > 20.001, inside);
  }
}

TEST(HeatSourcesTest, ARegionHeatsNothingBeyondTheRangeAndItsHeatIsCounted) {
  StillHeat<float> still(warmCube(4, 20.0));
  for (const double power : {1e9, -1e9}) {
    const double before = still.heat.totalEnthalpy_j() - still.heat.heatIn_j();
    still.heat.addRegion(
        {BlockShape::kSphere, Vec3d::Constant(0.04), Vec3d::Constant(1), power, 9});
    still.run(9.0);
    for (std::size_t i = 0; i < 64; ++i) {
      EXPECT_NEAR(still.heat.temperature(i), power > 0 ? 1000.0 : -273.15, 1e-6);
    }
    const double after = still.heat.totalEnthalpy_j() - still.heat.heatIn_j();
    EXPECT_NEAR(after, before, 1e-9 * std::abs(still.heat.totalEnthalpy_j()));
  }
}

/// Steam that gives its latent heat to the air condenses. It gets no colder than the air and
/// exchanges no heat with its neighbours.
TEST(HeatSourcesTest, SteamCondensesInTheAirAlone) {
  Scene scene = warmCube(4, 150.0);
  scene.thermal.speedup = 600.0;
  StillHeat<double> still(scene);
  std::vector<std::uint8_t> steam(64, 0);
  steam[10] = 1;
  ThermalStep<double> step;
  step.steam = &steam;
  step.dt_s = 1.0 / 60;
  for (int k = 0; k < 30; ++k) still.heat.advance(still.particles, still.neighbours, step);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_NEAR(still.heat.temperature(i), steam[i] ? 20.0 : 150.0, 1e-6);
  }
}

TEST(HeatSourcesTest, SteamCondensesAtTheRateOfItsSurface) {
  Scene scene = warmCube(1, 100.001);
  scene.thermal.speedup = 1.0;
  scene.steam.heat_transfer_w_m2k = 50.0;
  StillHeat<double> still(scene);
  const std::vector<std::uint8_t> steam(1, 1);
  ThermalStep<double> step;
  step.steam = &steam;
  step.dt_s = 1.0;
  const double before = still.heat.totalEnthalpy_j();
  still.heat.advance(still.particles, still.neighbours, step);
  const double radius = 12 * std::cbrt(3 * std::pow(0.02, 3) / (4 * M_PI));
  EXPECT_NEAR((before - still.heat.totalEnthalpy_j()) / (50 * 80 * 4 * M_PI * radius * radius), 1.0,
              1e-3);
}

}  // namespace heat_sources_test
}  // namespace ice_ice_baby
