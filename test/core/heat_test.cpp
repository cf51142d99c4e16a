// Heat between particles, from the air and from regions: what is kept, what is bounded, what is
// told.
#include "ice_ice_baby/heat.h"

#include <gtest/gtest.h>

#include "heat_fixture.h"

namespace ice_ice_baby {
namespace {

using test::StillHeat;
using test::warmCube;

/// Ice at -60 degrees with water of 30 degrees on top, in insulated walls that fit.
Scene iceUnderWater() {
  Scene scene = warmCube(8, -60.0);
  const double d = scene.fluid.spacing_m;
  scene.blocks[0] = test::blockOf({-4 * d, -4 * d, 0}, {4 * d, 4 * d, 4 * d});
  scene.blocks[0].celsius = -60.0;
  scene.blocks.push_back(test::blockOf({-4 * d, -4 * d, 4 * d}, {4 * d, 4 * d, 8 * d}));
  scene.blocks[1].celsius = 30.0;
  scene.containers.push_back(test::tankOf(Vec3d::Constant(8 * d), false));
  scene.heat.speedup = 6000.0;
  return scene;
}

template <class Real>
void shake(StillHeat<Real>& still, double step_m) {
  test::Random random(7);
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const Vec3d step = step_m * random.direction();
    still.particles.position.add(i, step.cast<Real>());
  }
}

template <class Real>
double meanOfMagnitudes_j(const StillHeat<Real>& still) {
  double sum = 0.0;
  for (const double h : still.heat.enthalpy()) sum += std::abs(h);
  const double h = still.scene.supportRadius_m();
  return sum * particleMass_kg(still.scene.fluid, h);
}

template <class Real>
double driftWhileFreezing() {
  StillHeat<Real> still(iceUnderWater());
  shake(still, 0.1 * still.scene.fluid.spacing_m);
  const double scale = meanOfMagnitudes_j(still), before = still.heat.totalEnthalpy_j();
  still.run(2e4);
  int ice = 0, partly = 0;
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    ice += still.heat.iceFraction(i) == 1.0;
    partly += still.heat.iceFraction(i) > 0.0 && still.heat.iceFraction(i) < 1.0;
  }
  EXPECT_GT(partly, 0);
  EXPECT_NE(ice, 256);
  EXPECT_EQ(still.heat.heatIn_j(), 0.0);
  return std::abs(still.heat.totalEnthalpy_j() - before) / scale;
}

TEST(HeatTest, InsulatedWaterKeepsItsEnthalpyWhileItFreezes) {
  const double in_double = driftWhileFreezing<double>(), in_float = driftWhileFreezing<float>();
  std::printf("relative drift: double %.1e, float %.1e\n", in_double, in_float);
  EXPECT_LT(in_double, 1e-13);
  EXPECT_LT(in_float, 1e-10);
}

TEST(HeatTest, IceAtFreezingUnderWaterAtFreezingStays) {
  Scene scene = iceUnderWater();
  scene.blocks[0].celsius = -1e-12;
  scene.blocks[1].celsius = 0.0;
  StillHeat<double> still(scene);
  const std::vector<double> before = still.heat.enthalpy();
  still.run(1e4);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(still.heat.enthalpy()[i], before[i], 1e-6);
  }
}

/// A long wave decays as the continuum has it: exp(-k alpha^2 t), here between mirrors.
TEST(HeatTest, WaveBetweenMirrorsDecaysAtItsRate) {
  Scene scene = test::coldColumn(3, 24, 0.01, 20.0);
  scene.planes.clear();
  scene.containers[0].position_m.z() = 0.0;
  scene.containers[0].size_m.z() = 0.24;
  const Block whole = scene.blocks[0];
  scene.blocks.clear();
  for (int layer = 0; layer < 24; ++layer) {
    Block slice = whole;
    slice.min_m.z() = 0.01 * layer;
    slice.max_m.z() = 0.01 * (layer + 1);
    slice.celsius = 20 + 10 * std::cos(M_PI * (layer + 0.5) / 24);
    scene.blocks.push_back(slice);
  }
  const double rate = std::pow(M_PI / 0.24, 2) * 0.58 / (1000 * 4186);
  scene.heat.speedup = 1200.0;
  StillHeat<double> still(scene);
  still.run(1 / rate);
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const double z = still.particles.position.z[i];
    EXPECT_NEAR(still.heat.temperature(i), 20 + 10 * std::exp(-1) * std::cos(M_PI * z / 0.24),
                0.01);
  }
}

TEST(HeatTest, SameBitsForAnyNumberOfThreads) {
  std::vector<double> first;
  for (const int threads : {1, 1, 2}) {
    Scene scene = iceUnderWater();
    scene.containers[0].heat = WallHeat::kTemperature;
    scene.heat.air_transfer_w_m2k = 100.0;
    StillHeat<float> still(scene);
    still.heat.addRegion({BlockShape::kBall, {0, 0, 0.1}, Vec3d::Constant(0.1), 50.0, 0.5});
    tbb::task_arena(threads).execute([&] { still.run(5e3); });
    if (first.empty()) first = still.heat.enthalpy();
    EXPECT_EQ(still.heat.enthalpy(), first);
  }
}

/// Every key over six decades, walls, air and a cloud of any density: nothing leaves the range of
/// what there was at the start, in the air and on the wall.
template <class Real>
void expectMaximumPrinciple(std::uint64_t seed) {
  test::Random random(seed);
  const auto decades = [&](double low) { return low * std::pow(10.0, random.uniform(0, 6)); };
  Scene scene = iceUnderWater();
  const double d = std::min(decades(1e-4), 10.0), old = scene.fluid.spacing_m;
  scene.fluid.spacing_m = d;
  for (Block& block : scene.blocks) {
    block.min_m *= d / old;
    block.max_m *= d / old;
  }
  scene.containers[0].size_m *= d / old;
  scene.containers[0].heat = WallHeat::kTemperature;
  scene.containers[0].celsius = -90.0;
  scene.containers[0].open_top = true;
  HeatParams& heat = scene.heat;
  heat.speedup = decades(10);
  heat.air_transfer_w_m2k = decades(1);
  heat.ice_capacity_j_kgk = decades(1);
  heat.water_capacity_j_kgk = decades(1);
  heat.ice_conductivity_w_mk = decades(1e-2);
  heat.water_conductivity_w_mk = decades(1e-2);
  heat.fusion_j_kg = decades(100);
  StillHeat<Real> still(scene);
  shake(still, 0.4 * d);
  HeatStep<Real> step;
  step.dt_s = 1.0 / 60;
  step.air_c = 70.0;
  for (int k = 0; k < 3; ++k) still.heat.advance(still.particles, still.neighbours, step);
  EXPECT_GT(still.heat.passes(), 0);
  EXPECT_LE(still.heat.reachedSpeedup(), heat.speedup * (1 + 1e-12));
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const double celsius = still.heat.temperature(i);
    ASSERT_TRUE(celsius >= -90 - 1e-4 && celsius <= 70 + 1e-4) << celsius << " seed " << seed;
  }
}

TEST(HeatTest, NothingLeavesTheRangeOfItsSurroundings) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    expectMaximumPrinciple<double>(seed);
    expectMaximumPrinciple<float>(seed);
  }
}

TEST(HeatTest, TellsWhatSpeedupItReached) {
  Scene scene = iceUnderWater();
  scene.heat.speedup = 1e7;
  StillHeat<float> still(scene);
  HeatStep<float> step;
  step.dt_s = 1.0 / 60;
  still.heat.advance(still.particles, still.neighbours, step);
  EXPECT_EQ(still.heat.passes(), Heat<float>::kMostPasses);
  EXPECT_LT(still.heat.reachedSpeedup(), 1e7);
  EXPECT_GT(still.heat.reachedSpeedup(), 1e4);
}

TEST(HeatTest, NoTimeAndNoSpeedupChangeNothing) {
  for (const double speedup : {0.0, 100.0}) {
    Scene scene = iceUnderWater();
    scene.heat.speedup = speedup;
    StillHeat<float> still(scene);
    const std::vector<double> before = still.heat.enthalpy();
    HeatStep<float> step;
    step.dt_s = speedup == 0.0 ? 1.0 / 60 : 0.0;
    still.heat.advance(still.particles, still.neighbours, step);
    EXPECT_EQ(still.heat.enthalpy(), before);
    EXPECT_EQ(still.heat.reachedSpeedup(), 0.0);
  }
}

/// Area by the heat that warmer air brings in a moment; the transfer is so small that water
/// conducts far better.
double bareArea_m2(Scene scene) {
  scene.heat.air_transfer_w_m2k = 1e-3;
  StillHeat<double> still(scene);
  still.run(1.0, scene.blocks[0].celsius + 1.0);
  return still.heat.heatIn_j() / 1e-3;
}

/// Edges count as rounded, by a piece that shrinks with the spacing.
TEST(HeatTest, CubeIsBareOnItsSixSides) {
  for (const int n : {6, 12}) {
    const double share = bareArea_m2(warmCube(n, 20.0)) / (6 * std::pow(0.02 * n, 2));
    std::printf("bare area of %d^3 particles: %.3f of its sides\n", n, share);
    EXPECT_NEAR(share, 1.0, 1.6 / n);
  }
}

/// The wall goes on above the water and so covers a little of the particles next to it.
TEST(HeatTest, WallsKeepTheAirAway) {
  Scene scene = warmCube(8, 20.0);
  scene.blocks[0] = test::blockOf({-0.08, -0.08, 0}, {0.08, 0.08, 0.16});
  scene.containers.push_back(test::tankOf(Vec3d::Constant(0.16), true));
  EXPECT_NEAR(bareArea_m2(scene) / (0.16 * 0.16), 1.0, 0.1);
  scene.containers[0].open_top = false;
  EXPECT_EQ(bareArea_m2(scene), 0.0);
}

TEST(HeatTest, ASmallBlockCoolsInAirLikeALump) {
  Scene scene = warmCube(6, 80.0);
  scene.heat.air_transfer_w_m2k = 0.1;
  const double area = bareArea_m2(scene);
  const double mass = 216 * particleMass_kg(scene.fluid, scene.supportRadius_m());
  const double half_life_s = std::log(2) * mass * 4186 / (0.1 * area);
  scene.heat.speedup = half_life_s;
  StillHeat<double> still(scene);
  still.run(half_life_s, 20.0);
  const double kelvin = still.heat.totalEnthalpy_j() / mass - 334e3;
  EXPECT_NEAR(kelvin / 4186, 50.0, 0.3);
}

TEST(HeatTest, ARegionHeatsWhatIsInItAndEnds) {
  Scene scene = warmCube(8, 20.0);
  scene.heat.water_conductivity_w_mk = 0.0;
  scene.heat.speedup = 2.0;
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

TEST(HeatTest, ARegionHeatsNothingBeyondTheRangeAndKeepsTheLedger) {
  StillHeat<float> still(warmCube(4, 20.0));
  for (const double power : {1e9, -1e9}) {
    const double before = still.heat.totalEnthalpy_j() - still.heat.heatIn_j();
    still.heat.addRegion({BlockShape::kBall, Vec3d::Constant(0.04), Vec3d::Constant(1), power, 9});
    still.run(9.0);
    for (std::size_t i = 0; i < 64; ++i) {
      EXPECT_NEAR(still.heat.temperature(i), power > 0 ? 1000.0 : -273.15, 1e-6);
    }
    const double after = still.heat.totalEnthalpy_j() - still.heat.heatIn_j();
    EXPECT_NEAR(after, before, 1e-9 * std::abs(still.heat.totalEnthalpy_j()));
  }
}

/// A puff whose latent heat the air takes condenses; it never falls below the air, and its
/// neighbours feel nothing of it.
TEST(HeatTest, SteamCondensesInTheAirAlone) {
  Scene scene = warmCube(4, 150.0);
  scene.heat.speedup = 600.0;
  StillHeat<double> still(scene);
  std::vector<std::uint8_t> steam(64, 0);
  steam[10] = 1;
  HeatStep<double> step;
  step.steam = &steam;
  step.dt_s = 1.0 / 60;
  for (int k = 0; k < 30; ++k) still.heat.advance(still.particles, still.neighbours, step);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_NEAR(still.heat.temperature(i), steam[i] ? 20.0 : 150.0, 1e-6);
  }
}

TEST(HeatTest, SteamCondensesAtTheRateOfItsSurface) {
  Scene scene = warmCube(1, 100.001);
  scene.heat.speedup = 1.0;
  scene.steam.transfer_w_m2k = 50.0;
  StillHeat<double> still(scene);
  const std::vector<std::uint8_t> steam(1, 1);
  HeatStep<double> step;
  step.steam = &steam;
  step.dt_s = 1.0;
  const double before = still.heat.totalEnthalpy_j();
  still.heat.advance(still.particles, still.neighbours, step);
  const double radius = 12 * std::cbrt(3 * std::pow(0.02, 3) / (4 * M_PI));
  EXPECT_NEAR((before - still.heat.totalEnthalpy_j()) / (50 * 80 * 4 * M_PI * radius * radius), 1.0,
              1e-3);
}

}  // namespace
}  // namespace ice_ice_baby
