// The loop as a whole: closed forms, conservation, stages, samples.
#include "simulation/simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "fixtures.h"
#include "metrics/density_meter.h"
#include "spawn/spawn_particles.h"

namespace ice_ice_baby {
namespace simulator_test {

using test::floatingCube;
using test::fullTank;

std::vector<std::string> stageNames(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const StageStats& stage : simulation.stages()) names.push_back(stage.name);
  return names;
}

bool holds(const Simulation& simulation, const std::string& stage) {
  const std::vector<std::string> names = stageNames(simulation);
  return std::find(names.begin(), names.end(), stage) != names.end();
}

double substepOf(const Scene& scene) {
  return 1.0 / (scene.solver.frame_rate_hz * scene.substeps());
}

void run(Simulation& simulation, int frames) {
  for (int k = 0; k < frames; ++k) simulation.advanceFrame();
}

TEST(SimulatorTest, FreeFallIsSymplecticEuler) {
  for (const int iterations : {0, 1, 3}) {
    Scene scene = floatingCube(1);
    scene.gravity_m_s2 = {0.3, -0.2, -9.81};
    scene.blocks[0].velocity_m_s = {1, 2, 3};
    scene.solver.iterations = iterations;
    Simulator<double> simulator(scene, 1);
    const Vec3d x0 = simulator.particles().position.at(0);
    run(simulator, 60);
    const double t = 1.0, dt = substepOf(scene);
    const Vec3d x = x0 + Vec3d(1, 2, 3) * t + 0.5 * scene.gravity_m_s2 * t * (t + dt);
    EXPECT_LT((simulator.particles().position.at(0) - x).norm(), 1e-12);
    EXPECT_LT(
        (simulator.particles().velocity.at(0) - Vec3d(1, 2, 3) - scene.gravity_m_s2 * t).norm(),
        1e-12);
  }
}

TEST(SimulatorTest, ZeroIterationsLeaveEveryParticleBallistic) {
  Scene scene = floatingCube(4);
  scene.gravity_m_s2 = {0, 0, -9.81};
  scene.solver.iterations = 0;
  Simulator<double> simulator(scene, 1);
  std::vector<ParticleSample> before, after;
  simulator.sample(before, 1);
  run(simulator, 30);
  simulator.sample(after, 1);
  const double fall = 0.5 * 9.81 * 0.5 * (0.5 + substepOf(scene));
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR(after[k].z, before[k].z - fall, 1e-6);
    EXPECT_NEAR(after[k].x, before[k].x, 1e-6);
  }
}

TEST(SimulatorTest, CoulombFrictionStopsASlidingParticleWhereItShould) {
  Scene scene = floatingCube(1);
  scene.gravity_m_s2 = {0, 0, -9.81};
  scene.blocks[0].velocity_m_s = {1, 0, 0};
  scene.planes.emplace_back();
  scene.planes[0].name = "ground";
  scene.planes[0].friction = 0.2;
  Simulator<double> simulator(scene, 1);
  const double x0 = simulator.particles().position.x[0];
  run(simulator, 60);
  const double slid = simulator.particles().position.x[0] - x0;
  EXPECT_NEAR(slid, 1.0 / (2 * 0.2 * 9.81), substepOf(scene));
  EXPECT_LT(simulator.report().max_speed_m_s, 1e-12);
}

TEST(SimulatorTest, MomentumIsKeptInFreeFlightLiquidFreezingAndFrozen) {
  Scene scene = floatingCube(6);
  scene.blocks[0].velocity_m_s = {1, -2, 0.5};
  scene.blocks.push_back(test::blockOf({0.31, 0, 0}, {0.51, 0.3, 0.3}));
  scene.blocks[1].velocity_m_s = {-2, 0, 0};
  scene.schedule = {{0.1, -5, 0.2}};
  Simulator<double> simulator(scene, 1);
  const Vec3d before = test::sumOf(simulator.particles().velocity);
  const double scale = test::sumOfNorms(simulator.particles().velocity);
  for (int frame = 0; frame < 40; ++frame) {
    run(simulator, 1);
    ASSERT_LT((test::sumOf(simulator.particles().velocity) - before).norm(), 1e-9 * scale)
        << "frame " << frame;
  }
  EXPECT_EQ(simulator.report().strictness, 1.0);
  EXPECT_GT(simulator.report().springs, 0u);
}

TEST(SimulatorTest, MeltedIceLeavesNoSpringsAndNoStages) {
  const auto simulation = makeSimulation(fullTank(5), Precision::kFloat, 1);
  simulation->setTemperature(-10, 0);
  run(*simulation, 3);
  EXPECT_TRUE(holds(*simulation, "correct_springs"));
  EXPECT_GT(simulation->report().springs, 0u);
  simulation->setTemperature(20, 0);
  run(*simulation, 1);
  EXPECT_FALSE(holds(*simulation, "make_springs"));
  EXPECT_FALSE(holds(*simulation, "correct_springs"));
  EXPECT_EQ(simulation->report().springs, 0u);
  std::vector<SpringSample> springs;
  simulation->sampleSprings(springs, 100);
  EXPECT_TRUE(springs.empty());
}

TEST(SimulatorTest, StagesOfFreezingWaterAreInTheOrderOfAlgorithm1) {
  const auto full = makeSimulation(fullTank(3));
  full->setTemperature(-10, 0);
  run(*full, 1);
  EXPECT_EQ(stageNames(*full),
            (std::vector<std::string>{"predict", "coarse_level", "neighbours", "make_springs",
                                      "lambda", "delta_p", "collide", "correct_springs", "position",
                                      "velocity", "viscosity", "report"}));
  for (const StageStats& stage : full->stages()) EXPECT_GT(stage.calls, 0u) << stage.name;
}

TEST(SimulatorTest, AColliderMovedAndMovedBackWithinAFrameStays) {
  const auto simulation = makeSimulation(fullTank(4), Precision::kDouble, 1);
  Posed away;
  away.position = {1, 0, 0};
  simulation->moveCollider("tank", away);
  simulation->moveCollider("tank", Posed());
  run(*simulation, 1);
  EXPECT_EQ(simulation->colliderPose("tank").position, Vec3d(0, 0, 0));
}

TEST(SimulatorTest, ZeroParticlesRunAndReportNothing) {
  Scene scene;
  scene.planes.emplace_back();
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    const auto simulation = makeSimulation(scene, precision);
    simulation->setTemperature(-10, 0);
    run(*simulation, 5);
    EXPECT_EQ(simulation->report().particles, 0u);
    EXPECT_EQ(simulation->report().density_error_mean, 0.0);
    EXPECT_EQ(simulation->report().rms_speed_m_s, 0.0);
    EXPECT_EQ(measureDensityError(*simulation).max, 0.0);
    std::vector<ParticleSample> samples(3);
    simulation->sample(samples, 1);
    EXPECT_TRUE(samples.empty());
  }
}

TEST(SimulatorTest, SamplesComeInOrderOfIdAtTheStride) {
  Scene scene = test::splash();
  const auto simulation = makeSimulation(scene);
  run(*simulation, 30);
  std::vector<ParticleSample> all, some, one;
  simulation->sample(all, 1);
  simulation->sample(some, 7);
  simulation->sample(one, 1000000);
  ASSERT_EQ(all.size(), simulation->report().particles);
  ASSERT_EQ(some.size(), (all.size() + 6) / 7);
  ASSERT_EQ(one.size(), 1u);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k].id, k);
  for (std::size_t k = 0; k < some.size(); ++k) {
    EXPECT_EQ(some[k].id, 7 * k);
    EXPECT_EQ(some[k].x, all[7 * k].x);
  }
  simulation->sample(some, 0);
  EXPECT_EQ(some.size(), all.size()) << "a stride of 0 counts as 1";
}

TEST(SimulatorTest, SpringSamplesAreThinnedEvenlyToTheLimit) {
  const auto simulation = makeSimulation(fullTank(5));
  simulation->setTemperature(-10, 0);
  run(*simulation, 1);
  std::vector<SpringSample> springs;
  simulation->sampleSprings(springs, 1000000);
  EXPECT_EQ(springs.size(), simulation->report().springs);
  simulation->sampleSprings(springs, 50);
  EXPECT_LE(springs.size(), 50u);
  EXPECT_GE(springs.size(), 25u);
  simulation->sampleSprings(springs, 0);
  EXPECT_TRUE(springs.empty());
}

TEST(SimulatorTest, SpawnsEachBlockOnItsLatticeInTheOrderOfTheFile) {
  Scene scene = floatingCube(2);
  scene.blocks.push_back(test::blockOf({1, 1, 1}, {1.15, 1.05, 1.05}));
  scene.blocks[1].velocity_m_s = {0, 0, 2};
  std::vector<Spawn> spawns;
  const Particles<double> particles = spawnParticles<double>(scene, spawns);
  ASSERT_EQ(particles.size(), 11u);
  EXPECT_EQ(std::int64_t(particles.size()), particleCount(scene));
  ASSERT_EQ(spawns.size(), 2u);
  EXPECT_EQ(spawns[0].first_id, 0u);
  EXPECT_EQ(spawns[0].count, 8u);
  EXPECT_EQ(spawns[1].first_id, 8u);
  EXPECT_EQ(spawns[1].count, 3u);
  EXPECT_LT((particles.position.at(0) - Vec3d::Constant(0.025)).norm(), 1e-15);
  EXPECT_LT((particles.position.at(10) - Vec3d(1.125, 1.025, 1.025)).norm(), 1e-12);
  EXPECT_EQ(particles.velocity.at(8), Vec3d(0, 0, 2));
}

TEST(SimulatorTest, SpeedLimitActsIsCountedAndHoldsTheParticles) {
  Scene scene = floatingCube(2);
  scene.solver.max_speed_m_s = 1.0;
  scene.blocks[0].velocity_m_s = {5, 0, 0};
  const auto simulation = makeSimulation(scene, Precision::kDouble);
  simulation->advanceFrame();
  EXPECT_GT(simulation->report().speed_limited, 0u);
  EXPECT_LE(simulation->report().max_speed_m_s, 1.0 + 1e-12);
  std::vector<ParticleSample> samples;
  simulation->sample(samples, 1);
  // One substep at the given speed may pass before the limit acts.
  EXPECT_LE(samples[0].x, 0.025 + 1.0 / 60 + 5.0 * substepOf(scene));
}

TEST(SimulatorTest, QualityChoosesSubstepsUnlessTheSceneDoes) {
  Scene scene = floatingCube(2);
  const std::map<Quality, int> substeps{
      {Quality::kFast, 3}, {Quality::kBalanced, 5}, {Quality::kAccurate, 10}};
  for (const auto& [quality, count] : substeps) {
    scene.solver.quality = quality;
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    EXPECT_EQ(simulation->scene().solver.substeps, count);
    EXPECT_EQ(simulation->advanceFrame().substeps, count);
  }
  scene.solver.substeps = 2;
  EXPECT_EQ(makeSimulation(scene)->advanceFrame().substeps, 2);
}

TEST(SimulatorTest, SubstepsBoundTheFallOfWater) {
  // dt = sqrt(0.008 d / g), rounded to a whole number of substeps per frame of 1/60 s.
  const std::map<double, int> substeps{{1e-2, 6}, {1e-3, 19}, {1e-4, 59}};
  for (const auto& [spacing_m, count] : substeps) {
    Scene scene = floatingCube(2);
    scene.gravity_m_s2 = {0, 0, -9.81};
    scene.fluid.spacing_m = spacing_m;
    scene.blocks[0].max_m = scene.blocks[0].min_m + Vec3d::Constant(2 * spacing_m);
    EXPECT_EQ(makeSimulation(scene)->advanceFrame().substeps, count) << spacing_m << " m";
  }
  Scene scene = floatingCube(2);
  const auto simulation = makeSimulation(scene);
  simulation->setGravity({0, 0, -981});
  simulation->advanceFrame();
  for (int frame = 0; frame < 4; ++frame) simulation->advanceFrame();
  const double d_m = scene.fluid.spacing_m;
  EXPECT_EQ(simulation->report().substeps, int(std::ceil(std::sqrt(981 / (0.008 * d_m)) / 60)));
}

TEST(SimulatorTest, SubstepsFollowTheTargetError) {
  std::map<double, double> mean_substeps;
  for (const double target : {0.01, 0.001}) {
    Scene scene = fullTank(8);
    scene.solver.coarse_level = false;
    scene.solver.target_error = target;
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    double error = 0.0;
    for (int frame = 0; frame < 90; ++frame) {
      const StepReport& report = simulation->advanceFrame();
      if (frame < 30) continue;
      error += report.density_error_mean / 60;
      mean_substeps[target] += report.substeps / 60.0;
    }
    EXPECT_LT(error, target);
  }
  EXPECT_LT(mean_substeps[0.01], mean_substeps[0.001]);
}

TEST(SimulatorTest, APoolComesToRest) {
  Scene scene = fullTank(8);
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  run(*simulation, 240);
  // Twice lambda at walls, or relaxation 0.7 in one sweep, would keep it at 40 to 120 mm/s.
  EXPECT_LT(simulation->report().rms_speed_m_s, 0.01);
}

/// Two cubes collide and part; a warm start that outlived the contact would pull or push them.
TEST(SimulatorTest, KineticEnergyDoesNotRiseWithoutWork) {
  Scene scene = floatingCube(6);
  scene.solver.viscosity_1_s = 0.0;
  scene.blocks[0].velocity_m_s = {1, 0, 0};
  scene.blocks.push_back(test::blockOf({0.3, 0, 0}, {0.6, 0.3, 0.3}));
  scene.blocks[1].velocity_m_s = {-1, 0, 0};
  Simulator<double> simulator(scene, 1);
  const double before = simulator.report().kinetic_energy_j;
  for (int frame = 0; frame < 60; ++frame) {
    run(simulator, 1);
    ASSERT_LE(simulator.report().kinetic_energy_j, before * (1 + 1e-9)) << "frame " << frame;
  }
}

TEST(SimulatorTest, IceRestsWithoutSleep) {
  Scene scene = fullTank(6, true);
  scene.schedule = {{0.2, -10, 0.5}};
  scene.springs.sleep_speed_m_s = 0.0;
  Simulator<float> simulator(scene, 1);
  run(simulator, 180);
  // Springs that also pull in later sweeps would keep it at millimetres a second.
  EXPECT_LT(simulator.report().rms_speed_m_s, 5e-4);
}

TEST(SimulatorTest, PressureOfARestingPoolGrowsWithDepth) {
  Scene scene = fullTank(8, true);
  const double d = scene.fluid.spacing_m;
  const auto simulation = makeSimulation(scene, Precision::kDouble, 1);
  run(*simulation, 240);
  std::vector<ParticleSample> samples;
  simulation->sample(samples);
  double measured = 0.0, expected = 0.0;
  for (const ParticleSample& p : samples) {
    if (p.z < 2 * d || p.z > 6 * d) continue;
    measured += double(p.pressure_pa);
    expected += 9810.0 * (8 * d - double(p.z));
  }
  EXPECT_NEAR(measured / expected, 1.0, 0.1);
}

}  // namespace simulator_test
}  // namespace ice_ice_baby
