#include "thermal/thermal_boundaries.h"

#include <gtest/gtest.h>

#include "ice_ice_baby/errors.h"
#include "thermal/thermal_fixture.h"

namespace ice_ice_baby {
namespace thermal_boundaries_test {

using test::StillHeat;

constexpr double kSpacing_m = 0.02;

struct Walls {
  explicit Walls(const Scene& s)
      : scene(s),
        colliders(scene, scene.fluid.spacing_m / 2),
        lattice(scene),
        curve(scene.thermal),
        walls(scene, colliders, lattice, curve) {}

  Scene scene;
  Colliders<double> colliders;
  ConductionLattice lattice;
  EnthalpyCurve curve;
  ThermalBoundaries<double> walls;
};

Scene plate(ThermalBoundary heat) {
  Scene scene = test::warmCube(4, 20.0);
  scene.planes.emplace_back();
  scene.planes[0].name = "plate";
  scene.planes[0].heat = heat;
  scene.planes[0].celsius = 50.0;
  scene.planes[0].flux_w_m2 = 1000.0;
  return scene;
}

TEST(ThermalBoundariesTest, LayersOfTheLatticeShareTheWholeArea) {
  for (const double support : {1.42, 2.0, 3.1}) {
    Scene scene = plate(ThermalBoundary::kFlux);
    scene.fluid.support_radius_m = support * kSpacing_m;
    const ConductionLattice lattice(scene);
    double sum = 0.0;
    for (int layer = 0; layer < 4; ++layer) sum += lattice.wallShare((layer + 0.5) * kSpacing_m);
    EXPECT_NEAR(sum, 1.0, 1e-12) << support;
  }
}

TEST(ThermalBoundariesTest, LatticeConductsAlongEachAxisAsTheContinuumDoes) {
  for (const double support : {1.42, 2.0, 3.1}) {
    Scene scene = plate(ThermalBoundary::kFlux);
    scene.fluid.support_radius_m = support * kSpacing_m;
    const ConductionLattice lattice(scene);
    double moment = 0.0;  // of T = z^2, Laplacian 2
    for (int x = -4; x <= 4; ++x) {
      for (int y = -4; y <= 4; ++y) {
        for (int z = -4; z <= 4; ++z) {
          const double r = kSpacing_m * std::sqrt(double(x * x + y * y + z * z));
          if (z != 0) moment += lattice.length_m(r) * std::pow(kSpacing_m * z, 2);
        }
      }
    }
    EXPECT_NEAR(moment / (2 * lattice.volume_m3), 1.0, 1e-12) << support;
  }
}

TEST(ThermalBoundariesTest, ParticleAtRestOnAPlateIsHalfASpacingOfWaterAway) {
  const Walls walls(plate(ThermalBoundary::kTemperature));
  const auto contact = walls.walls.at({0, 0, kSpacing_m / 2});
  EXPECT_NEAR(contact.length_m / kSpacing_m, 2.0, 1e-3);
  EXPECT_NEAR(contact.level, 0.58 * 50, 1e-9);
  EXPECT_EQ(walls.walls.at({0, 0, 2 * kSpacing_m}).length_m, 0.0);
  EXPECT_EQ(walls.walls.at({0, 0, -kSpacing_m}).length_m, 0.0);
  const double closest = walls.walls.at({0, 0, kSpacing_m / 4}).length_m;
  EXPECT_EQ(walls.walls.at({0, 0, 1e-9}).length_m, closest);
}

TEST(ThermalBoundariesTest, BallConductsAsAShellAndAHugeOneAsAPlate) {
  Scene scene = plate(ThermalBoundary::kTemperature);
  const double flat = Walls(scene).walls.at({0, 0, kSpacing_m / 2}).length_m;
  scene.planes.clear();
  scene.spheres.emplace_back();
  scene.spheres[0].heat = ThermalBoundary::kTemperature;
  for (const double radius : {0.05, 1.0, 1000.0}) {
    scene.spheres[0].radius_m = radius;
    const double shell = Walls(scene).walls.at({0, 0, radius + kSpacing_m / 2}).length_m;
    EXPECT_NEAR(shell / flat, radius / (radius + kSpacing_m / 2), 1e-6);
  }
}

TEST(ThermalBoundariesTest, PlateUnderTheFloorOfATankDoesNotCount) {
  Scene scene = plate(ThermalBoundary::kTemperature);
  scene.containers.push_back(test::tankOf(Vec3d::Constant(1), true));
  scene.containers[0].position_m.z() = -1e-3;
  EXPECT_GT(Walls(scene).walls.at({0, 0, 0.01}).length_m, 0.0);
  scene.containers[0].position_m.z() = 1e-3;
  EXPECT_EQ(Walls(scene).walls.at({0, 0, 0.011}).length_m, 0.0);
}

TEST(ThermalBoundariesTest, RampsFromItsTemperatureToTheTarget) {
  Walls walls(plate(ThermalBoundary::kInsulated));
  EXPECT_FALSE(walls.walls.active());
  EXPECT_TRUE(walls.walls.mirrors(0));
  walls.walls.set("plate", -10.0, 6.0);
  EXPECT_TRUE(walls.walls.active());
  EXPECT_FALSE(walls.walls.mirrors(0));
  EXPECT_EQ(walls.walls.celsius("plate"), 50.0);
  for (int k = 0; k < 4; ++k) walls.walls.advance(0.5);
  EXPECT_NEAR(walls.walls.celsius("plate"), 30.0, 1e-12);
  walls.walls.advance(100.0);
  EXPECT_EQ(walls.walls.celsius("plate"), -10.0);
  walls.walls.set("plate", 3.0, 0.0);
  EXPECT_EQ(walls.walls.celsius("plate"), 3.0);
  EXPECT_THROW(walls.walls.set("plait", 3.0, 0.0), InvalidInput);
}

template <class Real>
void expectFluxAndLedger() {
  StillHeat<Real> still(plate(ThermalBoundary::kFlux));
  const double before = still.heat.totalEnthalpy_j();
  still.run(100.0);
  const double expected = 1000.0 * std::pow(4 * kSpacing_m, 2) * 100.0;
  EXPECT_NEAR(still.heat.heatIn_j() / expected, 1.0, 1e-3);
  EXPECT_NEAR(still.heat.totalEnthalpy_j() - before, still.heat.heatIn_j(), 1e-10 * before);
}

TEST(ThermalBoundariesTest, FluxHeatsByItsAreaAndTime) {
  expectFluxAndLedger<double>();
  expectFluxAndLedger<float>();
}

TEST(ThermalBoundariesTest, EnthalpyChangesByTheHeatOfWallsAndAir) {
  Scene scene = plate(ThermalBoundary::kTemperature);
  scene.planes[0].celsius = -50.0;
  scene.thermal.air_heat_transfer_w_m2k = 500.0;
  scene.thermal.speedup = 1000.0;
  StillHeat<float> still(scene);
  const double before = still.heat.totalEnthalpy_j();
  still.run(4000.0);
  EXPECT_LT(still.heat.heatIn_j(), -0.1 * before);
  EXPECT_NEAR(still.heat.totalEnthalpy_j() - before, still.heat.heatIn_j(), 1e-10 * before);
}

TEST(ThermalBoundariesTest, AWallConductsInProportionToTheVolumeOfAParticle) {
  const auto heatAt = [](double relative_volume) {
    StillHeat<double> still(plate(ThermalBoundary::kTemperature));
    const std::vector<double> volume(still.particles.size(), relative_volume);
    ThermalStep<double> step;
    step.volume = &volume;
    step.dt_s = 1e-3;
    still.heat.advance(still.particles, still.neighbours, step);
    EXPECT_EQ(still.heat.passes(), 1);
    return still.heat.heatIn_j();
  };
  EXPECT_GT(heatAt(1.0), 0.0);
  EXPECT_NEAR(heatAt(1.09) / heatAt(1.0), 1.09, 1e-9);
}

/// Between a warm wall and a cold one the profile is straight and the flux k dT / thickness.
TEST(ThermalBoundariesTest, SlabBetweenTwoWallsHasAStraightProfile) {
  Scene scene = test::coldColumn(3, 8, kSpacing_m, 20.0);
  scene.planes.push_back(scene.planes[0]);
  scene.planes[1].name = "lid";
  scene.planes[1].position_m.z() = 8 * kSpacing_m;
  scene.planes[1].rpy_deg = {180, 0, 0};
  scene.planes[1].celsius = 60.0;
  scene.thermal.water_specific_heat_j_kgk = 100.0;
  scene.thermal.speedup = 1e4;
  StillHeat<double> still(scene);
  still.run(3e5);
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const double z = still.particles.position.z[i];
    EXPECT_NEAR(still.heat.temperature(i), 20 + 40 * z / (8 * kSpacing_m), 1e-3);
  }
}

TEST(ThermalBoundariesTest, SteamCondensesOnAColdPlateThatItTouches) {
  Scene scene = plate(ThermalBoundary::kTemperature);
  scene.steam.heat_transfer_w_m2k = 0.0;
  scene.blocks[0].celsius = 101.0;
  StillHeat<double> still(scene);
  const std::vector<std::uint8_t> steam(64, 1);
  ThermalStep<double> step;
  step.steam = &steam;
  step.dt_s = 1.0;
  still.heat.advance(still.particles, still.neighbours, step);
  for (std::size_t i = 0; i < 64; ++i) {
    const bool touches = still.particles.position.z[i] < kSpacing_m;
    EXPECT_EQ(still.heat.temperature(i) < 101.0, touches);
  }
  EXPECT_NEAR(still.heat.heatIn_j() / (16 * 5000 * std::pow(kSpacing_m, 2) * -51), 1.0, 1e-9);
}

}  // namespace thermal_boundaries_test
}  // namespace ice_ice_baby
