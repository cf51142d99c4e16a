// Checkpoints go on with the same bits, and what is damaged or senseless is refused.
#include "ice_ice_baby/checkpoint.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulator.h"

namespace ice_ice_baby {
namespace {

using test::blockOf;
using test::fullTank;
using test::splash;
using test::tankOf;

/// A scene, and what somebody does to it before frame `frame`.
struct Story {
  std::string name;
  Scene scene;
  std::function<void(Simulation&, int frame)> act = [](Simulation&, int) {};
  int frames = 40;

  friend std::ostream& operator<<(std::ostream& out, const Story& story) {
    return out << story.name;
  }
};

Scene heated(double spacing_m) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  scene.heat.enabled = true;
  return scene;
}

Scene freezingSplash(Preset preset) {
  Scene scene;
  applyPreset(scene, preset, 0.05);
  scene.fluid.spacing_m = 0.05;
  scene.blocks = splash().blocks;
  scene.containers = splash().containers;
  scene.schedule = {{0.15, -10, 0.2}, {0.5, 20, 0.1}};
  return scene;
}

Story sheetStory() {
  Scene scene = splash();
  scene.blocks[0] = blockOf({-0.3, -0.2, 0.4}, {0.3, 0.2, 0.45});
  scene.blocks[0].sheet = true;
  scene.blocks[0].rpy_deg.y() = 20;
  return {"sheet", scene};
}

/// The tank turns and rises; in frame 20 a move is asked for that the checkpoint holds undone.
Story movedStory() {
  const auto move = [](Simulation& simulation, int frame) {
    const double s = 0.01 * frame;
    simulation.moveCollider("tank", poseOf({s, 0, s / 2}, {5 * s, 30 * s, 0}));
    if (frame == 12) simulation.setGravity({1, 2, -8});
  };
  return {"moved_tank", splash(), move};
}

Story targetStory() {
  Scene scene = splash();
  scene.solver.target_error = 0.003;
  return {"target_error", scene};
}

Story plainFlightStory() {
  Scene scene = splash();
  scene.solver.iterations = 0;
  return {"no_iterations", scene};
}

/// Water that boils off a hot floor, under a torch, with a block of ice that falls into it.
Story kettleStory(double compliance_m_n) {
  Scene scene = heated(0.02);
  scene.heat.speedup = 2000.0;
  scene.ice.compliance_m_n = compliance_m_n;
  scene.blocks = {blockOf({-0.06, -0.06, 0.0}, {0.06, 0.06, 0.08}),
                  blockOf({-0.05, -0.05, 0.1}, {0.05, 0.05, 0.16})};
  scene.blocks[0].celsius = 99.0;
  scene.blocks[1].celsius = -10.0;
  scene.containers = {tankOf({0.12, 0.12, 0.4}, false, "pot")};
  scene.planes.emplace_back();
  scene.planes[0].name = "floor";
  const auto act = [](Simulation& simulation, int frame) {
    if (frame == 5) simulation.setTemperature(300.0, 0.5, "pot");
    if (frame == 8) simulation.setTemperature(-5.0, 0.4);
    if (frame != 3 && frame != 15) return;
    HeatRegion torch;
    torch.size_m = Vec3d::Constant(0.1);
    torch.power_w = frame == 3 ? 2000.0 : -3000.0;
    torch.duration_s = 0.35;
    simulation.heatRegion(torch);
  };
  return {compliance_m_n > 0 ? "elastic_ice" : "kettle", scene, act, 60};
}

/// Balls of ice that fall on a plate and on each other, some of them at rest and asleep, until one
/// more is thrown among them by the plate.
Story hailStory() {
  Scene scene = heated(0.02);
  scene.planes.emplace_back();
  scene.planes[0].name = "plate";
  for (int k = 0; k < 6; ++k) {
    Block ball = blockOf({-0.05, -0.05, 0.001 + 0.11 * k}, {0.05, 0.05, 0.101 + 0.11 * k});
    ball.shape = BlockShape::kBall;
    ball.celsius = -20.0;
    if (k > 0) ball.min_m.x() += 0.02, ball.max_m.x() += 0.02;
    scene.blocks.push_back(ball);
  }
  scene.blocks.push_back(blockOf({0.3, 0.3, 0.001}, {0.4, 0.4, 0.041}));
  scene.blocks.back().celsius = -20.0;
  const auto act = [](Simulation& simulation, int frame) {
    if (frame >= 55)
      simulation.moveCollider("plate", poseOf({0, 0, 0.004 * (frame - 54)}, {0, 0, 0}));
  };
  return {"hail", scene, act, 70};
}

/// Water that freezes on a cold sphere, sticks to it and is carried along.
Story coldSphereStory() {
  Scene scene = heated(0.02);
  scene.heat.speedup = 3000.0;
  scene.blocks = {blockOf({-0.08, -0.08, 0.0}, {0.08, 0.08, 0.08})};
  scene.blocks[0].celsius = 0.5;
  scene.containers = {tankOf({0.3, 0.16, 0.3}, true)};
  scene.spheres.emplace_back();
  scene.spheres[0].name = "ball";
  scene.spheres[0].position_m = Vec3d(0, 0, 0.1);
  scene.spheres[0].radius_m = 0.04;
  scene.spheres[0].heat = WallHeat::kTemperature;
  scene.spheres[0].celsius = -80.0;
  const auto act = [](Simulation& simulation, int frame) {
    if (frame < 30) return;
    simulation.moveCollider("ball", poseOf({0.002 * (frame - 29), 0, 0.1}, {0, 0, 0}));
  };
  return {"cold_sphere", scene, act, 50};
}

std::vector<Story> stories() {
  return {{"water", splash()},
          {"freezing", freezingSplash(Preset::kDefault)},
          {"freezing_paper", freezingSplash(Preset::kPaper)},
          sheetStory(),
          movedStory(),
          targetStory(),
          plainFlightStory(),
          kettleStory(0.0),
          kettleStory(1e-6),
          hailStory(),
          coldSphereStory()};
}

/// Every frame of the story as a checkpoint, made when all is asked for and before it happens.
std::vector<std::string> tell(const Story& story, Precision precision) {
  const auto simulation = makeSimulation(story.scene, precision, 1);
  std::vector<std::string> told;
  for (int frame = 0; frame < story.frames; ++frame) {
    story.act(*simulation, frame);
    told.push_back(encodeCheckpoint(*simulation));
    simulation->advanceFrame();
  }
  return told;
}

/// A checkpoint holds the state and the report, so equal ones are equal in every bit of both.
void expectGoesOn(const Story& story, const std::vector<std::string>& told, int from) {
  const auto simulation = decodeCheckpoint(told[std::size_t(from)], "memory", 2);
  const int end = std::min(from + 12, story.frames);
  for (int frame = from; frame < end; ++frame) {
    if (frame > from) story.act(*simulation, frame);
    ASSERT_TRUE(encodeCheckpoint(*simulation) == told[std::size_t(frame)])
        << story.name << ": saved before frame " << from << ", differs before " << frame;
    simulation->advanceFrame();
  }
}

class StoryTest : public testing::TestWithParam<std::tuple<Story, Precision>> {};

TEST_P(StoryTest, GoesOnWithTheBitsOfTheUninterruptedRun) {
  const auto& [story, precision] = GetParam();
  const std::vector<std::string> told = tell(story, precision);
  for (int from = 0; from < story.frames; from += 7) expectGoesOn(story, told, from);
}

INSTANTIATE_TEST_SUITE_P(Of, StoryTest,
                         testing::Combine(testing::ValuesIn(stories()),
                                          testing::Values(Precision::kFloat, Precision::kDouble)),
                         [](const auto& made) {
                           const bool reference = std::get<1>(made.param) == Precision::kDouble;
                           return std::get<0>(made.param).name + (reference ? "_double" : "_float");
                         });

/// The stories would show nothing of ice that never froze.
TEST(CheckpointTest, TheStoriesTellOfAllThatAStateMayHold) {
  StepReport most;
  for (const Story& story : stories()) {
    const auto simulation = makeSimulation(story.scene, Precision::kFloat, 1);
    for (int frame = 0; frame < story.frames; ++frame) {
      story.act(*simulation, frame);
      const StepReport& report = simulation->advanceFrame();
      most.springs = std::max(most.springs, report.springs);
      most.bodies = std::max(most.bodies, report.bodies);
      most.bodies_asleep = std::max(most.bodies_asleep, report.bodies_asleep);
      most.steam_particles = std::max(most.steam_particles, report.steam_particles);
    }
  }
  EXPECT_GT(most.springs, 0U);
  EXPECT_GT(most.bodies, 5U);
  EXPECT_GT(most.bodies_asleep, 0U);
  EXPECT_GT(most.steam_particles, 0U);
}

TEST(CheckpointTest, WhatSleepsSleepsOnAndWakes) {
  Scene scene = fullTank(5, true);
  scene.temperature.initial_c = -10.0;
  const auto first = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < 600 && !first->report().asleep; ++k) first->advanceFrame();
  ASSERT_TRUE(first->report().asleep);
  const auto second = decodeCheckpoint(encodeCheckpoint(*first), "memory", 1);
  for (int frame = 0; frame < 12; ++frame) {
    if (frame == 4) first->setGravity({0, 0, 5});
    if (frame == 4) second->setGravity({0, 0, 5});
    ASSERT_EQ(first->report().asleep, second->report().asleep);
    ASSERT_TRUE(encodeCheckpoint(*first) == encodeCheckpoint(*second)) << frame;
    first->advanceFrame();
    second->advanceFrame();
  }
}

TEST(CheckpointTest, ASceneWithoutParticlesIsOneToo) {
  Scene scene = splash();
  scene.blocks.clear();
  const auto empty = makeSimulation(scene, Precision::kFloat, 1);
  empty->advanceFrame();
  EXPECT_EQ(decodeCheckpoint(encodeCheckpoint(*empty), "memory", 1)->stateHash(),
            empty->stateHash());
}

TEST(CheckpointTest, TheHashTellsOfWhatIsNotYetToBeSeen) {
  const auto simulation = makeSimulation(kettleStory(0.0).scene, Precision::kFloat, 1);
  std::vector<std::uint64_t> hashes{simulation->stateHash()};
  simulation->setGravity({0, 0, -5});
  hashes.push_back(simulation->stateHash());
  simulation->setTemperature(50, 10);
  hashes.push_back(simulation->stateHash());
  simulation->setTemperature(50, 10, "floor");
  hashes.push_back(simulation->stateHash());
  simulation->heatRegion({BlockShape::kBall, Vec3d::Zero(), Vec3d::Ones(), 10.0, 1.0});
  hashes.push_back(simulation->stateHash());
  simulation->moveCollider("pot", poseOf({0.1, 0, 0}, Vec3d::Zero()));
  hashes.push_back(simulation->stateHash());
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end());
}

/// What decodeCheckpoint says of the bytes; "" when it takes them.
std::string refusal(std::string_view bytes) {
  try {
    decodeCheckpoint(bytes, "some/run.ckpt", 1);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

std::string smallCheckpoint() {
  const auto simulation = makeSimulation(fullTank(2), Precision::kFloat, 1);
  simulation->advanceFrame();
  return encodeCheckpoint(*simulation);
}

TEST(DamagedCheckpointTest, OfAnyLesserLengthIsRefusedByName) {
  const std::string whole = smallCheckpoint();
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string why = refusal(std::string_view(whole).substr(0, length));
    ASSERT_EQ(why.rfind("some/run.ckpt: ", 0), 0U) << length << why;
    const bool tells = why.find(length < 8 ? "not a checkpoint" : "truncated") != why.npos;
    ASSERT_TRUE(tells) << length << why;
  }
  EXPECT_NE(refusal(whole + "x").find("too long"), std::string::npos);
}

TEST(DamagedCheckpointTest, WithAnyBitFlippedIsRefusedByName) {
  std::string bytes = smallCheckpoint();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
    ASSERT_EQ(refusal(bytes).rfind("some/run.ckpt: ", 0), 0U) << "bit " << bit;
    bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
  }
  EXPECT_EQ(refusal(bytes), "");
}

TEST(DamagedCheckpointTest, OfAnotherVersionOrNoneSaysSo) {
  std::string bytes = smallCheckpoint();
  bytes[8] = 77;
  EXPECT_NE(refusal(bytes).find("version 77"), std::string::npos) << refusal(bytes);
  EXPECT_NE(refusal("blocks: []").find("not a checkpoint"), std::string::npos);
  EXPECT_NE(refusal("").find("not a checkpoint"), std::string::npos);
}

/// What Simulation::write wrote, from behind the scene and the number of particles.
std::string stateOf(const Simulation& simulation) {
  StateWriter all, count;
  simulation.write(all);
  count(std::uint64_t(simulation.report().particles));
  return all.bytes().substr(all.bytes().find(count.bytes() + count.bytes()) + count.bytes().size());
}

/// A few bytes somewhere else than they were: small, or as large as an index or a double can be.
std::string forged(std::string state, test::Random& random, bool large) {
  const auto at = std::size_t(random.uniform(0, double(state.size() - 8)));
  if (large) return state.replace(at & ~std::size_t(7), 8, "\xff\xff\xff\x7f\xff\xff\xef\x7f");
  state[at] = char(random.uniform(0, 256));
  return state;
}

class ForgedTest : public testing::TestWithParam<Story> {};

/// Behind the checksum stands the reader itself, as bytes may be forged. What it takes must run.
TEST_P(ForgedTest, StatesAreRefusedOrRun) {
  test::Random random(7);
  Simulator<float> original(GetParam().scene, 1);
  original.setTemperature(-10.0, 0.0, "");
  for (int frame = 0; frame < 20; ++frame) original.advanceFrame();
  const std::string state = stateOf(original);
  int refused = 0;
  constexpr int kForged = 80;
  Simulator<float> simulator(GetParam().scene, 1);
  for (int k = 0; k < kForged; ++k) {
    const std::string bytes = forged(state, random, k % 2 == 0);
    try {
      StateReader reader(bytes);
      simulator.read(reader);
      simulator.advanceFrame();
    } catch (const InvalidInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, kForged);
}

INSTANTIATE_TEST_SUITE_P(Of, ForgedTest,
                         testing::Values(hailStory(), kettleStory(0.0), coldSphereStory(),
                                         Story{"frozen", fullTank(3)}),
                         [](const auto& made) { return made.param.name; });

}  // namespace
}  // namespace ice_ice_baby
