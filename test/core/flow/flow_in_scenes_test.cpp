// Sources and drains together with everything else a scene may have: walls, water around the
// outlet, the limit on particles, heat, ice, sleep, threads and checkpoints.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "flow/flow_fixtures.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/source_warning.h"
#include "simulation/simulator.h"
#include "simulation/stories.h"

namespace ice_ice_baby {
namespace flow_in_scenes_test {

using test::outflow;
using test::Story;
using test::tap;

/// A tap above a tank with a slow drain in its floor; the commands change the flow.
Story filling(const std::string& name, Scene scene) {
  Source source = tap({0.1, 0, 0.4}, 0.05, 2.3);
  source.temperature_c = 80.0;
  Source jet = tap({-0.2, 0, 0.3}, 0.03, 0.0);
  jet.name = "jet";
  jet.flow_l_min = 150.0;
  jet.direction = {1, 0.3, 0.5};
  jet.open = false;
  scene.sources = {source, jet};
  scene.drains = {outflow({-0.5, -0.25, 0}, {0.5, 0.25, 0.1}, 300.0),
                  outflow({0.3, -0.25, 0}, {0.5, 0.25, 0.06})};
  scene.drains[1].name = "overflow";
  const auto act = [](Simulation& simulation, int frame) {
    if (frame == 5) simulation.setSource("jet", true, 0.0);
    if (frame == 11) simulation.setSource("tap", false, 800.0);
    if (frame == 17) simulation.setSource("tap", true, 0.0);
    if (frame == 26) simulation.setSource("jet", true, 77.0);
  };
  return {name, scene, act};
}

Scene iceInWater() {
  Scene scene = test::heated(0.04);
  scene.containers = {test::tankOf({1.0, 0.5, 1.0}, true)};
  scene.blocks = {test::blockOf({-0.5, -0.25, 0.0}, {0.5, 0.25, 0.16}),
                  test::blockOf({-0.1, -0.1, 0.17}, {0.1, 0.1, 0.29})};
  scene.blocks[1].celsius = -10.0;
  return scene;
}

/// Both outlets are carried about and turned; one of them jumps.
Story carrying() {
  Story story = filling("carried", test::splash());
  story.scene.sources[1].follow_frame = "hand";
  const auto act = [flow = story.act](Simulation& simulation, int frame) {
    flow(simulation, frame);
    const double s = 0.01 * frame;
    simulation.moveSource("tap", poseOf({0.1 - s, s / 2, 0.4}, {180 + 400 * s, 100 * s, 0}));
    if (frame < 9) return;
    const double far_m = frame < 20 ? 0.0 : 0.8;
    simulation.moveSource("jet", poseOf({-0.2 + far_m, s, 0.3}, {90 + 50 * s, 0, 20}));
  };
  story.act = act;
  return story;
}

std::vector<Story> stories() {
  Scene dry = test::splash();
  dry.blocks.clear();
  Scene freezing = test::splash();
  freezing.schedule = {{0.1, -10, 0.2}};
  Scene adapted = test::splash();
  adapted.solver.target_error = 0.003;
  Scene paper = test::freezingSplash(Preset::kPaper);
  return {filling("water", test::splash()),
          filling("dry", dry),
          filling("freezing", freezing),
          filling("adapted", adapted),
          filling("paper", paper),
          filling("ice", iceInWater()),
          carrying()};
}

void expectWhole(const Simulation& simulation, std::size_t start) {
  const StepReport& report = simulation.report();
  ASSERT_EQ(report.particles + report.spilled + report.drained, start + report.poured);
  ASSERT_EQ(report.non_finite, 0U);
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  ASSERT_EQ(samples.size(), report.particles);
  for (std::size_t k = 1; k < samples.size(); ++k) ASSERT_LT(samples[k - 1].id, samples[k].id);
}

void runTo(const Story& story, Simulation& simulation, int frames) {
  while (int(simulation.report().frame) < frames) {
    story.act(simulation, int(simulation.report().frame));
    simulation.advanceFrame();
  }
}

std::unique_ptr<Simulation> reloaded(const Simulation& simulation, int threads) {
  return decodeCheckpoint(encodeCheckpoint(simulation), "memory", threads);
}

class FlowInScenesTest : public testing::TestWithParam<Story> {};

TEST_P(FlowInScenesTest, EveryParticleIsCountedAndNoIdIsUsedTwice) {
  const auto simulation = makeSimulation(GetParam().scene, Precision::kFloat, 2);
  const std::size_t start = simulation->report().particles;
  std::set<std::uint32_t> now, gone;
  for (int frame = 1; frame <= GetParam().frames; ++frame) {
    runTo(GetParam(), *simulation, frame);
    expectWhole(*simulation, start);
    std::vector<ParticleSample> samples;
    simulation->sample(samples);
    std::set<std::uint32_t> ids;
    for (const ParticleSample& s : samples) ids.insert(s.id);
    for (const std::uint32_t id : now) {
      if (ids.count(id) == 0) gone.insert(id);
    }
    for (const std::uint32_t id : ids) ASSERT_EQ(gone.count(id), 0U) << "used twice";
    now = ids;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(simulation->report().poured, 60U);
  if (GetParam().name != "freezing" && GetParam().name != "paper") {
    EXPECT_GT(simulation->report().drained, 10U);
  }
}

TEST_P(FlowInScenesTest, TheSameBitsOnOneTwoAndFourThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const auto simulation = makeSimulation(GetParam().scene, Precision::kFloat, threads);
    runTo(GetParam(), *simulation, GetParam().frames);
    hashes.push_back(simulation->stateHash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST_P(FlowInScenesTest, ACheckpointGoesOnWithTheSameBitsAndCounts) {
  const auto whole = makeSimulation(GetParam().scene, Precision::kFloat, 1);
  std::vector<std::unique_ptr<Simulation>> others;
  for (const int frame : {6, 13, 27, GetParam().frames}) {
    runTo(GetParam(), *whole, frame);
    for (const auto& other : others) runTo(GetParam(), *other, frame);
    others.push_back(reloaded(*whole, 2));
    ASSERT_EQ(others.back()->stateHash(), whole->stateHash()) << frame;
  }
  for (const auto& other : others) {
    EXPECT_EQ(other->stateHash(), whole->stateHash());
    EXPECT_EQ(other->report().poured, whole->report().poured);
    EXPECT_EQ(other->report().blocked, whole->report().blocked);
    EXPECT_EQ(other->report().drained, whole->report().drained);
  }
}

INSTANTIATE_TEST_SUITE_P(In, FlowInScenesTest, testing::ValuesIn(stories()),
                         [](const auto& made) { return made.param.name; });

/// 30 cm of water over an outlet at the floor. What has no room waits, and nothing explodes.
TEST(FlowInScenes, ASubmergedOutletFillsTheTankCalmly) {
  for (const double speed_m_s : {0.5, 2.0, 6.0}) {
    Scene scene;
    scene.fluid.spacing_m = 0.02;
    scene.containers = {test::tankOf({0.4, 0.4, 1.0}, true)};
    scene.blocks = {test::blockOf({-0.2, -0.2, 0}, {0.2, 0.2, 0.3})};
    scene.sources = {tap({0, 0, 0.03}, 0.04, speed_m_s)};
    scene.sources[0].direction = {0, 0, 1};
    const auto simulation = makeSimulation(scene, Precision::kFloat, 2);
    double worst = 0.0;
    while (simulation->report().time_s < 1.0) {
      const StepReport& report = simulation->advanceFrame();
      worst = std::max(worst, report.density_error_mean);
      ASSERT_LT(report.max_speed_m_s, 1.5 * speed_m_s + 3.0) << report.time_s;
    }
    const StepReport& report = simulation->report();
    EXPECT_LT(worst, 0.02) << speed_m_s;
    const double due = test::particles_1_s(scene.sources[0], 0.02);
    EXPECT_NEAR(double(report.poured), due, 0.02 * due + 13) << "and a layer";
    EXPECT_NEAR(double(report.poured + report.blocked), due, 0.01 * due + 2 * 13);
  }
}

/// Between two frames the water would have got 17 cm far.
TEST(FlowInScenes, FastWaterDoesNotPassAWallInFrontOfTheOutlet) {
  Scene scene = test::jet(tap({0, 0, 0.03}, 0.03, 20.0), 0.01);
  Plane wall;
  wall.name = "wall";
  wall.size_x_m = wall.size_y_m = 0.4;
  wall.thickness_m = 0.01;
  scene.planes = {wall};
  Simulator<float> simulator(scene, 1);
  for (int k = 0; k < 6; ++k) {
    simulator.advanceFrame();
    const auto& x = simulator.particles().position;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const bool over_the_wall = std::max(std::abs(x.x[i]), std::abs(x.y[i])) < 0.19f;
      ASSERT_TRUE(!over_the_wall || x.z[i] > 0.0049f) << x.z[i];
    }
  }
  EXPECT_GT(simulator.report().poured, 0U);
}

TEST(FlowInScenes, AnOutletInASolidThatMovedThereWaits) {
  Scene scene = test::jet(tap(Vec3d::Zero(), 0.03, 1.0), 0.01);
  scene.spheres = {test::ball({1, 0, 0}, 0.1)};
  Simulator<float> simulator(scene, 1);
  for (int k = 0; k < 10; ++k) simulator.advanceFrame();
  const std::uint64_t poured = simulator.report().poured;
  EXPECT_GT(poured, 0U);
  EXPECT_EQ(simulator.report().blocked, 0U);
  simulator.placeColliders({{"ball", poseOf(Vec3d::Zero(), Vec3d::Zero())}});
  for (int k = 0; k < 10; ++k) simulator.advanceFrame();
  EXPECT_EQ(simulator.report().poured, poured);
  EXPECT_GT(simulator.report().blocked, 0U);
  simulator.placeColliders({{"ball", poseOf({1, 0, 0}, Vec3d::Zero())}});
  for (int k = 0; k < 10; ++k) simulator.advanceFrame();
  EXPECT_GT(simulator.report().poured, poured);
}

TEST(FlowInScenes, ASourceStopsAtTheLimitAndSaysSo) {
  Scene scene = test::jet(tap(Vec3d::Zero(), 0.03, 1.0), 0.02);
  scene.limits.max_particles = 100;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const double layer = siteCount(scene.sources[0], 0.02);
  bool warned_before = false;
  for (int k = 0; k < 60; ++k) {
    const StepReport& report = simulation->advanceFrame();
    ASSERT_LE(report.particles, 100U);
    const std::string warning = sourceWarning(scene, report);
    ASSERT_EQ(warning.empty(), report.particles < 90 && report.sources_stopped == 0);
    warned_before |= warning.rfind("sources will stop soon: ", 0) == 0;
  }
  EXPECT_TRUE(warned_before);
  const StepReport& report = simulation->report();
  EXPECT_GT(double(report.particles), 100 - layer);
  EXPECT_EQ(report.sources_stopped, 1U);
  EXPECT_EQ(report.blocked, 0U) << "which is another reason";
  EXPECT_EQ(sourceWarning(scene, report),
            "1 source has stopped: " + std::to_string(report.particles) +
                " of limits.max_particles = 100 particles are in the scene; turn sources off, add "
                "a drain, or raise the limit");
  simulation->setSource("tap", false);
  EXPECT_EQ(simulation->report().sources_stopped, 0U);
  EXPECT_EQ(sourceWarning(simulation->scene(), simulation->report()), "");
}

TEST(FlowInScenes, ASourceGoesOnWhenADrainMakesRoom) {
  Scene scene = test::jet(tap(Vec3d::Zero(), 0.03, 1.0), 0.02);
  scene.limits.max_particles = 100;
  scene.drains = {outflow({-1, -1, -1}, {1, 1, -0.05})};
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < 120; ++k) simulation->advanceFrame();
  const double due = 2 * test::particles_1_s(scene.sources[0], 0.02);
  EXPECT_NEAR(double(simulation->report().poured), due, siteCount(scene.sources[0], 0.02));
  EXPECT_GT(simulation->report().drained, 500U);
}

TEST(FlowInScenes, FrozenWaterSleepsOnlyWhileAllSourcesAreOff) {
  Scene scene = test::fullTank(4);
  scene.temperature.initial_c = -10.0;
  scene.sources = {tap({0, 0, 0.5}, 0.02, 0.5)};
  scene.sources[0].open = false;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < 120 && !simulation->report().asleep; ++k) simulation->advanceFrame();
  ASSERT_TRUE(simulation->report().asleep);
  simulation->setSource("tap", true, 30.0);
  for (int k = 0; k < 60; ++k) {
    simulation->advanceFrame();
    ASSERT_FALSE(simulation->report().asleep);
  }
  EXPECT_GT(simulation->report().poured, 0U);
}

TEST(FlowInScenes, WaterHasTheTemperatureOfItsSource) {
  Scene scene = test::heated(0.02);
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.sources = {tap({0, 0, 1}, 0.02, 1.0), tap({1, 0, 1}, 0.02, 1.0)};
  scene.sources[0].temperature_c = 80.0;
  scene.sources[1].temperature_c = 0.0;
  scene.sources[1].name = "cold";
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < 20; ++k) simulation->advanceFrame();
  std::vector<ParticleSample> samples;
  simulation->sample(samples);
  ASSERT_GT(samples.size(), 20U);
  for (const ParticleSample& s : samples) {
    EXPECT_NEAR(s.temperature_c, s.x < 0.5 ? 80.0 : 0.0, 0.01);
    EXPECT_EQ(s.phase, Phase::kWater);
  }
}

std::vector<std::string> namesOf(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const StageStats& stage : simulation.stages()) names.push_back(stage.name);
  return names;
}

TEST(FlowInScenes, OnlyScenesWithThemHaveTheStages) {
  Scene scene = test::splash();
  const auto without = makeSimulation(scene, Precision::kFloat, 1);
  scene.sources = {tap({0, 0, 0.5}, 0.02, 0.5)};
  scene.drains = {outflow({0, 0, 0}, {0.1, 0.1, 0.1})};
  scene.solver.substeps = 4;
  const auto with = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < 3; ++k) {
    without->advanceFrame();
    with->advanceFrame();
  }
  std::vector<std::string> names = namesOf(*without);
  names.insert(names.end() - 1, {"sources", "drains"});
  EXPECT_EQ(namesOf(*with), names) << "before the report";
  for (const StageStats& stage : with->stages()) {
    EXPECT_TRUE(stage.name != "sources" || stage.calls == 12U) << stage.calls;
    EXPECT_TRUE(stage.name != "drains" || stage.calls == 3U) << stage.calls;
  }
}

}  // namespace flow_in_scenes_test
}  // namespace ice_ice_baby
