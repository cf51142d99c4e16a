// Particles that leave the bounds of the scene are removed and counted, through every stage that a
// scene may have.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "scene/lattice.h"
#include "simulation/simulator.h"
#include "simulation/stories.h"

namespace ice_ice_baby {
namespace bounds_test {

using test::blockOf;
using test::Story;

constexpr int kFrames = 32;

/// A story whose bounds are so narrow that some of it leaves them. Those with heat fall upwards,
/// out of their tanks.
Story narrowed(Story story) {
  if (story.scene.thermal.enabled) story.scene.gravity_m_s2 = Vec3d(0, 0, 3);
  Eigen::AlignedBox3d box;
  for (const Block& block : story.scene.blocks) box.extend(boxAround(block));
  story.scene.bounds.min_m = box.min() - Vec3d(0.02, 0.02, 0.001);
  story.scene.bounds.max_m = box.max() + Vec3d(0.02, 0.02, 0.02);
  return story;
}

std::vector<Story> narrowedStories() {
  std::vector<Story> all;
  for (const Story& story : test::stories()) all.push_back(narrowed(story));
  return all;
}

void expectFinite(const StepReport& report) {
  describe(report, [&](const char* name, const auto& value, const char*) {
    ASSERT_TRUE(std::isfinite(double(value))) << name;
  });
  ASSERT_EQ(report.non_finite, 0U);
}

/// @param particles at the start
void expectWhole(const Simulation& simulation, std::size_t particles) {
  const StepReport& report = simulation.report();
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  ASSERT_EQ(report.particles, samples.size());
  ASSERT_EQ(report.particles + report.spilled, particles);
  const BoundsParams& bounds = simulation.scene().bounds;
  for (const ParticleSample& s : samples) {
    const Vec3d x(s.x, s.y, s.z);
    const Vec3d beyond = (bounds.min_m - x).cwiseMax(x - bounds.max_m);
    ASSERT_LT(beyond.maxCoeff(), 1e-5) << s.id;
  }
  expectFinite(report);
}

std::unique_ptr<Simulation> reloaded(const Simulation& simulation) {
  return decodeCheckpoint(encodeCheckpoint(simulation), "memory", 1);
}

class BoundsTest : public testing::TestWithParam<Story> {};

TEST_P(BoundsTest, EveryParticleIsWithinThemOrCounted) {
  const auto simulation = makeSimulation(GetParam().scene, Precision::kFloat, 2);
  const std::size_t particles = simulation->report().particles;
  for (int frame = 0; frame < kFrames; ++frame) {
    GetParam().act(*simulation, frame);
    simulation->advanceFrame();
    expectWhole(*simulation, particles);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(simulation->report().spilled, 0U);
}

TEST_P(BoundsTest, TheSameBitsAndTheSameCountOnAnyNumberOfThreadsAndAfterACheckpoint) {
  const auto one = makeSimulation(GetParam().scene, Precision::kFloat, 1);
  const auto two = makeSimulation(GetParam().scene, Precision::kFloat, 2);
  std::unique_ptr<Simulation> later;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (Simulation* each : {one.get(), two.get(), later.get()}) {
      if (!each) continue;
      GetParam().act(*each, frame);
      each->advanceFrame();
    }
    if (frame == kFrames / 2) later = reloaded(*one);
  }
  for (const Simulation* other : {two.get(), later.get()}) {
    EXPECT_EQ(other->stateHash(), one->stateHash());
    EXPECT_EQ(other->report().spilled, one->report().spilled);
  }
}

INSTANTIATE_TEST_SUITE_P(In, BoundsTest, testing::ValuesIn(narrowedStories()),
                         [](const auto& made) { return made.param.name; });

/// A cube of 64 particles with nothing below it.
Scene fallingCube() {
  Scene scene = test::floatingCube(4);
  scene.gravity_m_s2 = Vec3d(0, 0, -9.81);
  scene.bounds.min_m.z() = -1.0;
  return scene;
}

void expectEmpty(Simulation& simulation, std::size_t particles) {
  for (int frame = 0; frame < 50; ++frame) {
    simulation.advanceFrame();
    expectWhole(simulation, particles);
  }
  const StepReport& report = simulation.report();
  EXPECT_EQ(report.spilled, particles);
  EXPECT_EQ(report.density_error_mean, 0.0);
  EXPECT_EQ(report.density_error_max, 0.0);
  EXPECT_EQ(report.kinetic_energy_j, 0.0);
  EXPECT_EQ(report.enthalpy_j, 0.0);
  EXPECT_EQ(report.ice_bodies + report.ice_particles + report.springs, 0U);
}

TEST(Bounds, WaterWithNothingBelowItFallsOutAndTheRunGoesOnWithoutIt) {
  for (const bool heat : {false, true}) {
    Scene scene = fallingCube();
    scene.thermal.enabled = heat;
    scene.solver.target_error = 0.002;
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    expectEmpty(*simulation, 64);
  }
  Scene paper = fallingCube();
  applyPreset(paper, Preset::kPaper, paper.fluid.spacing_m);
  const auto simulation = makeSimulation(paper, Precision::kDouble, 1);
  expectEmpty(*simulation, 64);
}

TEST(Bounds, FrozenWaterAndASheetFallOutWithTheirSprings) {
  Scene scene = fallingCube();
  scene.temperature.initial_c = -10.0;
  scene.blocks.push_back(blockOf({0.5, 0, 0}, {0.7, 0.2, 0.05}));
  scene.blocks[1].sheet = true;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  simulation->advanceFrame();
  ASSERT_GT(simulation->report().springs, 0U);
  expectEmpty(*simulation, 80);
}

TEST(Bounds, SteamThatRisesLeaves) {
  Scene scene = test::heated(0.05);
  scene.blocks = {blockOf(Vec3d::Zero(), Vec3d::Constant(0.1))};
  scene.blocks[0].celsius = 300.0;
  scene.steam.rise_speed_m_s = 2.0;
  scene.bounds.max_m.z() = 0.3;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  ASSERT_EQ(simulation->report().steam_particles, 8U);
  expectEmpty(*simulation, 8);
}

/// A bar of ice flies out through a side in layers; another stays.
TEST(Bounds, IceLeavesPieceByPieceAndItsBodyIsWhatRemains) {
  Scene scene = test::heated(0.02);
  scene.gravity_m_s2.setZero();
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.blocks = {blockOf({-0.2, 0, 0}, {0, 0.06, 0.06}), blockOf({-0.2, 0.2, 0}, {0, 0.26, 0.06})};
  for (Block& bar : scene.blocks) bar.celsius = -20.0;
  scene.blocks[0].velocity_m_s = {0.6, 0, 0};
  scene.bounds.max_m.x() = 0.05;
  Simulator<float> simulator(scene, 1);
  const std::size_t particles = simulator.report().particles;
  const double each_j = simulator.report().enthalpy_j / double(particles);
  std::size_t steps = 0;
  for (int frame = 0; frame < 40; ++frame) {
    const std::uint64_t before = simulator.report().spilled;
    const StepReport& report = simulator.advanceFrame();
    steps += report.spilled > before;
    expectWhole(simulator, particles);
    const bool gone = report.particles == particles / 2;
    EXPECT_EQ(report.ice_bodies, gone ? 1U : 2U);
    EXPECT_EQ(report.ice_particles, report.particles);
    EXPECT_NEAR(report.enthalpy_j, each_j * double(report.particles), 1e-6 * std::abs(each_j));
    EXPECT_NEAR(report.max_speed_m_s, gone ? 0.0 : 0.6, 1e-4) << "what remains flies on";
  }
  EXPECT_GT(steps, 5U) << "layer by layer";
  EXPECT_EQ(simulator.report().particles, particles / 2);
}

TEST(Bounds, WhereNothingLeavesTheyChangeNothing) {
  Scene scene = test::splash();
  const auto far = makeSimulation(scene, Precision::kFloat, 1);
  scene.bounds = {{-0.5, -0.25, 0}, {0.5, 0.25, 1}};
  const auto near = makeSimulation(scene, Precision::kFloat, 1);
  std::vector<ParticleSample> one, two;
  for (int frame = 0; frame < 30; ++frame) {
    far->advanceFrame();
    near->advanceFrame();
  }
  far->sample(one);
  near->sample(two);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    ASSERT_EQ(std::make_tuple(one[k].x, one[k].y, one[k].z),
              std::make_tuple(two[k].x, two[k].y, two[k].z));
  }
  EXPECT_EQ(near->report().spilled, 0U);
}

TEST(Bounds, DefaultsEndBeforeWaterInFreeFallReachesTheSpeedLimit) {
  const Scene scene;
  const double fall_m = std::pow(scene.solver.max_speed_m_s, 2) / (2 * 9.81);
  EXPECT_LT(-scene.bounds.min_m.z() + 5.0, fall_m);
  EXPECT_LT(scene.bounds.max_m.maxCoeff(), 64.0) << "friction";
}

TEST(Bounds, BlocksAndNewParticlesBeyondThemAreRefused) {
  const auto refusal = [](const std::function<void(Scene&)>& change) {
    Scene scene = fallingCube();
    change(scene);
    return test::refusalOf([&] { validate(scene); });
  };
  EXPECT_EQ(refusal([](Scene&) {}), "");
  EXPECT_EQ(refusal([](Scene& s) { s.bounds.max_m.y() = 0.15; }),
            "blocks.0 extends from 0 to 0.2 m along y, beyond the bounds [-40, 0.15]; move the "
            "block, or change bounds.min_m.1 or bounds.max_m.1");
  EXPECT_EQ(refusal([](Scene& s) { s.bounds.max_m = Vec3d::Constant(0.2); }), "");
  EXPECT_NE(refusal([](Scene& s) {
              s.bounds.max_m = Vec3d::Constant(0.2);
              s.blocks[0].rpy_deg.z() = 45;
            }).find("blocks.0 extends from -0.041421 to 0.241421 m along x"),
            std::string::npos);
  EXPECT_EQ(refusal([](Scene& s) { s.bounds.min_m.x() = 40; }),
            "bounds.min_m.0 = 40 must be below bounds.max_m.0 = 40");
  EXPECT_NE(test::refusalOf([] {
              parseScene("bounds: {max_m: [0, 0, 101]}");
            }).find("bounds.max_m.2 = 101 is outside"),
            std::string::npos);

  Simulator<float> simulator(fallingCube(), 1);
  const std::uint64_t hash = simulator.stateHash();
  EXPECT_THROW(simulator.addParticles({{0, 0, -1.1}}, {Vec3d::Zero()}, 20.0), InvalidInput);
  EXPECT_EQ(simulator.stateHash(), hash);
}

}  // namespace bounds_test
}  // namespace ice_ice_baby
