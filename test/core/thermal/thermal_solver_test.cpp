// Conduction between particles: conservation, bounds, and the speedup that is reached.
#include "thermal/thermal_solver.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "thermal/thermal_fixture.h"

namespace ice_ice_baby {
namespace thermal_solver_test {

using test::StillHeat;
using test::warmCube;

/// Water at 30 degrees on ice at -60, in an insulated tank that both fill.
Scene iceUnderWater() {
  Scene scene = warmCube(8, -60.0);
  const double d = scene.fluid.spacing_m;
  scene.blocks[0] = test::blockOf({-4 * d, -4 * d, 0}, {4 * d, 4 * d, 4 * d});
  scene.blocks[0].celsius = -60.0;
  scene.blocks.push_back(test::blockOf({-4 * d, -4 * d, 4 * d}, {4 * d, 4 * d, 8 * d}));
  scene.blocks[1].celsius = 30.0;
  scene.containers.push_back(test::tankOf(Vec3d::Constant(8 * d), false));
  scene.thermal.speedup = 6000.0;
  scene.ice.density_ratio = 1.0;  // so that both have one spacing
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

TEST(ThermalTest, InsulatedWaterKeepsItsEnthalpyWhileItFreezes) {
  const double in_double = driftWhileFreezing<double>(), in_float = driftWhileFreezing<float>();
  std::printf("relative drift: double %.1e, float %.1e\n", in_double, in_float);
  EXPECT_LT(in_double, 1e-13);
  EXPECT_LT(in_float, 1e-10);
}

TEST(ThermalTest, IceAtFreezingUnderWaterAtFreezingStays) {
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

/// Largest error, K, of the wave cos(pi z / length) in an insulated column when 1 / e of it is
/// left.
/// @param stretch of the spacing and of the size of the particles
double waveError_c(double stretch) {
  const double length = 0.24 * stretch;
  Scene scene = test::coldColumn(3, 24, 0.01, 20.0);
  scene.planes.clear();
  scene.containers[0].position_m.z() = 0.0;
  scene.containers[0].size_m = {0.03 * stretch, 0.03 * stretch, length};
  const Block whole = scene.blocks[0];
  scene.blocks.clear();
  for (int layer = 0; layer < 24; ++layer) {
    Block slice = whole;
    slice.min_m.z() = 0.01 * layer;
    slice.max_m.z() = 0.01 * (layer + 1);
    slice.celsius = 20 + 10 * std::cos(M_PI * (layer + 0.5) / 24);
    scene.blocks.push_back(slice);
  }
  const double density = 1000 / std::pow(stretch, 3);
  const double end_s = std::pow(length / M_PI, 2) * density * 4186 / 0.58;
  scene.thermal.speedup = end_s / 60;
  StillHeat<double> still(scene);
  auto& x = still.particles.position;
  for (std::size_t i = 0; i < x.size(); ++i) x.set(i, stretch * x.at(i));
  const std::vector<double> volume(x.size(), std::pow(stretch, 3));
  ThermalStep<double> step;
  step.dt_s = 0.1;
  step.volume = &volume;
  for (int k = 0; k < 600; ++k) still.heat.advance(still.particles, still.neighbours, step);
  double worst = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double expected = 20 + 10 * std::exp(-1) * std::cos(M_PI * x.z[i] / length);
    worst = std::max(worst, std::abs(still.heat.temperature(i) - expected));
  }
  return worst;
}

TEST(ThermalTest, WaveBetweenMirrorsDecaysAtItsRate) { EXPECT_LT(waveError_c(1.0), 0.01); }

/// Particles of ice at 917 kg/m^3 are 3 % further apart.
TEST(ThermalTest, WaveDecaysAtItsRateInWhatHasExpanded) { EXPECT_LT(waveError_c(1.0293), 0.05); }

TEST(ThermalTest, SameBitsForAnyNumberOfThreads) {
  std::vector<double> first;
  for (const int threads : {1, 1, 2}) {
    Scene scene = iceUnderWater();
    scene.containers[0].heat = ThermalBoundary::kTemperature;
    scene.thermal.air_heat_transfer_w_m2k = 100.0;
    StillHeat<float> still(scene);
    still.heat.addRegion({BlockShape::kSphere, {0, 0, 0.1}, Vec3d::Constant(0.1), 50.0, 0.5});
    tbb::task_arena(threads).execute([&] { still.run(5e3); });
    if (first.empty()) first = still.heat.enthalpy();
    EXPECT_EQ(still.heat.enthalpy(), first);
  }
}

/// With every key drawn from six decades, no temperature leaves the range that is spanned by the
/// start, the air and the wall.
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
  scene.containers[0].heat = ThermalBoundary::kTemperature;
  scene.containers[0].celsius = -90.0;
  scene.containers[0].open_top = true;
  ThermalParams& thermal = scene.thermal;
  thermal.speedup = decades(10);
  thermal.air_heat_transfer_w_m2k = decades(1);
  thermal.ice_specific_heat_j_kgk = decades(1);
  thermal.water_specific_heat_j_kgk = decades(1);
  thermal.ice_conductivity_w_mk = decades(1e-2);
  thermal.water_conductivity_w_mk = decades(1e-2);
  thermal.latent_heat_fusion_j_kg = decades(100);
  StillHeat<Real> still(scene);
  shake(still, 0.4 * d);
  ThermalStep<Real> step;
  step.dt_s = 1.0 / 60;
  step.air_c = 70.0;
  for (int k = 0; k < 3; ++k) still.heat.advance(still.particles, still.neighbours, step);
  EXPECT_GT(still.heat.passes(), 0);
  EXPECT_LE(still.heat.reachedSpeedup(), thermal.speedup * (1 + 1e-12));
  for (std::size_t i = 0; i < still.particles.size(); ++i) {
    const double celsius = still.heat.temperature(i);
    ASSERT_TRUE(celsius >= -90 - 1e-4 && celsius <= 70 + 1e-4) << celsius << " seed " << seed;
  }
}

TEST(ThermalTest, NothingLeavesTheRangeOfItsSurroundings) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    expectMaximumPrinciple<double>(seed);
    expectMaximumPrinciple<float>(seed);
  }
}

TEST(ThermalTest, ReportsTheSpeedupThatItReached) {
  Scene scene = iceUnderWater();
  scene.thermal.speedup = 1e7;
  StillHeat<float> still(scene);
  ThermalStep<float> step;
  step.dt_s = 1.0 / 60;
  still.heat.advance(still.particles, still.neighbours, step);
  EXPECT_EQ(still.heat.passes(), ThermalSolver<float>::kMaxPasses);
  EXPECT_LT(still.heat.reachedSpeedup(), 1e7);
  EXPECT_GT(still.heat.reachedSpeedup(), 1e4);
}

/// The resistances of half a spacing of water and of the air are in series.
TEST(ThermalTest, ADropAloneTakesOnTheTemperatureOfTheAir) {
  Scene scene = warmCube(1, 20.0);
  scene.thermal.air_heat_transfer_w_m2k = 50.0;
  StillHeat<double> still(scene);
  const double volume = particleVolume_m3(scene.fluid, scene.supportRadius_m());
  const double area = std::cbrt(36 * M_PI * volume * volume);
  const double across = 1 / (1 / 50.0 + 0.01 / scene.thermal.water_conductivity_w_mk);
  const double mass = particleMass_kg(scene.fluid, scene.supportRadius_m());
  const double rate = across * area / (mass * scene.thermal.water_specific_heat_j_kgk);
  still.run(60.0, 10.0);
  EXPECT_NEAR(still.heat.temperature(0), 10.0 + 10.0 * std::exp(-rate * 60.0), 0.1);
}

TEST(ThermalTest, NoTimeAndNoSpeedupChangeNothing) {
  for (const double speedup : {0.0, 100.0}) {
    Scene scene = iceUnderWater();
    scene.thermal.speedup = speedup;
    StillHeat<float> still(scene);
    const std::vector<double> before = still.heat.enthalpy();
    ThermalStep<float> step;
    step.dt_s = speedup == 0.0 ? 1.0 / 60 : 0.0;
    still.heat.advance(still.particles, still.neighbours, step);
    EXPECT_EQ(still.heat.enthalpy(), before);
    EXPECT_EQ(still.heat.reachedSpeedup(), 0.0);
  }
}

}  // namespace thermal_solver_test
}  // namespace ice_ice_baby
