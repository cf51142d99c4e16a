// Water and ice over a second or two of whole scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "fixtures.h"
#include "metrics/density_meter.h"
#include "metrics/escape_meter.h"
#include "unchecked.h"

namespace ice_ice_baby {
namespace dynamics_test {

using test::fullTank;
using test::splash;

void run(Simulation& simulation, int frames) {
  for (int k = 0; k < frames; ++k) simulation.advanceFrame();
}

std::vector<ParticleSample> samplesOf(const Simulation& simulation) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples, 1);
  return samples;
}

Vec3d placeOf(const ParticleSample& s) { return {s.x, s.y, s.z}; }

/// Mean height of the `layer` highest particles.
double surfaceHeight(const Simulation& simulation, std::size_t layer) {
  std::vector<double> heights;
  for (const ParticleSample& s : samplesOf(simulation)) heights.push_back(s.z);
  std::sort(heights.rbegin(), heights.rend());
  double sum = 0;
  for (std::size_t k = 0; k < layer; ++k) sum += heights[k];
  return sum / double(layer);
}

bool allFinite(const Simulation& simulation) {
  for (const ParticleSample& s : samplesOf(simulation)) {
    if (!std::isfinite(s.x + s.y + s.z + s.vx + s.vy + s.vz + s.density)) return false;
  }
  return simulation.report().non_finite == 0;
}

TEST(WaterTest, AColumnKeepsItsHeightAndItsDensity) {
  Scene scene = fullTank(12, true);
  scene.containers[0].size_m.z() = 1.0;
  const auto simulation = makeSimulation(scene);
  const double before = surfaceHeight(*simulation, 144) + 0.025;
  run(*simulation, 120);
  EXPECT_GE((surfaceHeight(*simulation, 144) + 0.025) / before, 0.98);
  EXPECT_LE((surfaceHeight(*simulation, 144) + 0.025) / before, 1.02);
  // Two iterations a substep leave 60 cm of water compressed by a quarter of a percent.
  EXPECT_LT(measureDensityError(*simulation).mean, 4e-3);
  EXPECT_LT(simulation->report().rms_speed_m_s, 0.1);
}

TEST(WaterTest, AViolentSplashStaysInItsContainer) {
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    const auto simulation = makeSimulation(splash(), precision);
    simulation->setGravity({40, 30, -100});
    run(*simulation, 20);
    simulation->setGravity({-100, 0, 100});
    for (int k = 0; k < 40; ++k) {
      simulation->advanceFrame();
      ASSERT_EQ(countEscaped(*simulation), 0u);
    }
    EXPECT_TRUE(allFinite(*simulation));
  }
}

TEST(WaterTest, AnOverfullContainerReportsItsErrorAndLosesNothing) {
  Scene scene = fullTank(5);
  scene.blocks.push_back(test::blockOf({-0.115, -0.115, 0.01}, {0.085, 0.085, 0.21}));
  const auto simulation = test::unchecked(scene);
  run(*simulation, 60);
  EXPECT_TRUE(allFinite(*simulation));
  EXPECT_EQ(countEscaped(*simulation), 0u);
  EXPECT_GT(measureDensityError(*simulation).mean, 0.1);
}

TEST(IceTest, ComesToRestSleepsAndWakes) {
  Scene scene = fullTank(6, true);
  scene.containers[0].size_m.z() = 0.6;
  scene.blocks[0].min_m.z() = 0.05;
  scene.blocks[0].max_m.z() = 0.35;
  scene.schedule = {{0.2, -10, 0.3}};
  const auto simulation = makeSimulation(scene);
  for (int k = 0; k < 600 && !simulation->report().asleep; ++k) simulation->advanceFrame();
  ASSERT_TRUE(simulation->report().asleep);
  const std::uint64_t frozen = simulation->stateHash();
  run(*simulation, 20);
  EXPECT_EQ(simulation->stateHash(), frozen) << "what sleeps does not move";

  simulation->setGravity({0, 0, 9.81});
  run(*simulation, 5);
  EXPECT_FALSE(simulation->report().asleep);
  EXPECT_NE(simulation->stateHash(), frozen);

  simulation->setGravity({0, 0, -9.81});
  simulation->setTemperature(20, 0);
  run(*simulation, 30);
  EXPECT_EQ(simulation->report().springs, 0u);
  EXPECT_FALSE(simulation->report().asleep);
}

TEST(IceTest, AFrozenBlockKeepsItsShapeInFreeFlight) {
  Scene scene = test::floatingCube(5);
  scene.temperature.initial_c = -10;
  scene.gravity_m_s2 = {0, 0, -9.81};
  const auto simulation = makeSimulation(scene, Precision::kDouble);
  const auto before = samplesOf(*simulation);
  run(*simulation, 60);
  const auto after = samplesOf(*simulation);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR(after[k].x - after[0].x, before[k].x - before[0].x, 1e-5);
    EXPECT_NEAR(after[k].z - after[0].z, before[k].z - before[0].z, 1e-5);
  }
}

TEST(IceTest, ASheetHoldsTogetherOverABall) {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.blocks.push_back(test::blockOf({-0.3, -0.3, 0.4}, {0.3, 0.3, 0.45}));
  scene.blocks[0].sheet = true;
  scene.spheres.push_back(test::ball({0, 0, 0.15}, 0.15));
  const auto simulation = makeSimulation(scene);
  const std::size_t springs = simulation->report().springs;
  run(*simulation, 90);
  EXPECT_EQ(simulation->report().springs, springs);
  std::vector<SpringSample> ends;
  simulation->sampleSprings(ends, 1 << 20);
  ASSERT_EQ(ends.size(), springs);
  for (const SpringSample& s : ends) {
    const double length = Vec3d(s.ax - s.bx, s.ay - s.by, s.az - s.bz).norm();
    EXPECT_LT(length, 0.05 * 1.5 * 1.25);
  }
}

TEST(PrecisionTest, FloatFollowsDoubleForAWhile) {
  const auto single = makeSimulation(splash(), Precision::kFloat);
  const auto twice = makeSimulation(splash(), Precision::kDouble);
  run(*single, 12);
  run(*twice, 12);
  const auto a = samplesOf(*single), b = samplesOf(*twice);
  double apart = 0;
  for (std::size_t k = 0; k < a.size(); ++k) apart += (placeOf(a[k]) - placeOf(b[k])).norm();
  EXPECT_LT(apart / double(a.size()), 1e-3) << "a fiftieth of the spacing, on average";
}

TEST(ScaleTest, ScenesATenthAndTenTimesAsLargeMoveAlike) {
  std::vector<std::vector<ParticleSample>> runs;
  for (const double scale : {0.1, 1.0, 10.0}) {
    Scene scene = splash();
    scene.fluid.spacing_m *= scale;
    scene.blocks[0].min_m *= scale;
    scene.blocks[0].max_m *= scale;
    scene.containers[0].size_m *= scale;
    scene.gravity_m_s2 *= scale;
    scene.solver.max_speed_m_s *= scale;
    const auto simulation = makeSimulation(scene, Precision::kDouble);
    run(*simulation, 12);
    runs.push_back(samplesOf(*simulation));
  }
  // Samples are floats, hence the tolerance.
  for (std::size_t k = 0; k < runs[1].size(); ++k) {
    const Vec3d one = placeOf(runs[1][k]);
    ASSERT_LT((10 * placeOf(runs[0][k]) - one).norm(), 1e-5) << k;
    ASSERT_LT((placeOf(runs[2][k]) / 10 - one).norm(), 1e-5) << k;
  }
}

TEST(ExtremesTest, NothingBecomesNotFiniteOrEscapes) {
  const auto survives = [](const char* what, auto&& change) {
    Scene scene = splash();
    change(scene);
    const auto simulation = test::unchecked(scene);
    run(*simulation, 10);
    EXPECT_TRUE(allFinite(*simulation)) << what;
    EXPECT_EQ(countEscaped(*simulation), 0u) << what;
  };
  survives("a step of one second", [](Scene& s) {
    s.solver.frame_rate_hz = 1;
    s.solver.substeps = 1;
  });
  survives("a step of a nanosecond's order", [](Scene& s) {
    s.solver.frame_rate_hz = 1e4;
    s.solver.substeps = 1000;
    s.blocks[0].max_m = s.blocks[0].min_m + Vec3d::Constant(0.1);
  });
  survives("gravity 1e4", [](Scene& s) { s.gravity_m_s2 = {0, 0, -1e4}; });
  survives("1000 m/s", [](Scene& s) {
    s.blocks[0].velocity_m_s = {1000, -1000, 1000};
    s.solver.max_speed_m_s = 1e5;
  });
  survives("blocks in the same place", [](Scene& s) { s.blocks.push_back(s.blocks[0]); });
  survives("a ball over all the water", [](Scene& s) {
    s.spheres.emplace_back();
    s.spheres[0].position_m = {0, 0, 0.3};
    s.spheres[0].radius_m = 0.2;
  });
  survives("40 iterations", [](Scene& s) { s.solver.iterations = 40; });
  survives("frozen at once", [](Scene& s) { s.temperature.initial_c = -273.15; });
}

}  // namespace dynamics_test
}  // namespace ice_ice_baby
