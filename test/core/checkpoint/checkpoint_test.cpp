// A restored checkpoint continues with the same bits as the run that saved it.
#include "ice_ice_baby/checkpoint.h"

#include <gtest/gtest.h>

#include "simulation/stories.h"

namespace ice_ice_baby {
namespace checkpoint_test {

using test::fullTank;
using test::splash;
using test::stories;
using test::Story;

/// A checkpoint before every frame of the story, after the commands for that frame.
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

/// Checkpoints hold the state and the report, so equal bytes mean that both are equal.
void expectGoesOn(const Story& story, const std::vector<std::string>& told, int from) {
  const auto simulation = decodeCheckpoint(told[std::size_t(from)], "memory", 2);
  const int end = std::min(from + 8, story.frames);
  for (int frame = from; frame < end; ++frame) {
    if (frame > from) story.act(*simulation, frame);
    ASSERT_TRUE(encodeCheckpoint(*simulation) == told[std::size_t(frame)])
        << story.name << ": saved before frame " << from << ", differs before " << frame;
    simulation->advanceFrame();
  }
}

class StoryTest : public testing::TestWithParam<std::tuple<Story, Precision>> {};

TEST_P(StoryTest, ContinuesWithTheBitsOfTheUninterruptedRun) {
  const auto& [story, precision] = GetParam();
  const std::vector<std::string> told = tell(story, precision);
  for (int from = 0; from < story.frames; from += 3) expectGoesOn(story, told, from);
}

INSTANTIATE_TEST_SUITE_P(Of, StoryTest,
                         testing::Combine(testing::ValuesIn(stories()),
                                          testing::Values(Precision::kFloat, Precision::kDouble)),
                         [](const auto& made) {
                           const bool reference = std::get<1>(made.param) == Precision::kDouble;
                           return std::get<0>(made.param).name + (reference ? "_double" : "_float");
                         });

/// Ensures that StoryTest meets springs, moving and sleeping ice, steam and jumps.
TEST(CheckpointTest, TheStoriesCoverEveryPartOfTheState) {
  StepReport max;
  int grew = 0, shrank = 0;  // frames in which the amount of ice rose and fell
  int swept = 0;             // frames in which ice moved by more than its width in a substep
  for (const Story& story : stories()) {
    const auto simulation = makeSimulation(story.scene, Precision::kFloat, 1);
    for (int frame = 0; frame < story.frames; ++frame) {
      story.act(*simulation, frame);
      const std::size_t ice = simulation->report().ice_particles;
      const StepReport& report = simulation->advanceFrame();
      grew += report.ice_particles > ice;
      shrank += report.ice_particles < ice;
      const double way_m = report.max_speed_m_s / (60.0 * report.substeps);
      swept += report.ice_bodies > 1 && report.ice_particles == report.particles && way_m > 0.08;
      max.speed_limited = std::max(max.speed_limited, report.speed_limited);
      max.springs = std::max(max.springs, report.springs);
      max.ice_bodies = std::max(max.ice_bodies, report.ice_bodies);
      max.ice_bodies_asleep = std::max(max.ice_bodies_asleep, report.ice_bodies_asleep);
      max.steam_particles = std::max(max.steam_particles, report.steam_particles);
    }
  }
  EXPECT_GT(max.springs, 0U);
  EXPECT_GT(max.ice_bodies, 5U);
  EXPECT_GT(max.ice_bodies_asleep, 0U);
  EXPECT_GT(max.steam_particles, 0U);
  EXPECT_GE(max.speed_limited, 600U) << "nothing was carried along by a collider that jumped";
  EXPECT_GT(swept, 5);
  EXPECT_GT(grew, 5);
  EXPECT_GT(shrank, 5);
}

TEST(CheckpointTest, SleepingIceStaysAsleepAndWakes) {
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

TEST(CheckpointTest, ASceneWithoutParticlesCanBeSaved) {
  Scene scene = splash();
  scene.blocks.clear();
  const auto empty = makeSimulation(scene, Precision::kFloat, 1);
  empty->advanceFrame();
  EXPECT_EQ(decodeCheckpoint(encodeCheckpoint(*empty), "memory", 1)->stateHash(),
            empty->stateHash());
}

TEST(CheckpointTest, TheHashCoversCommandsThatHaveNotActedYet) {
  const auto simulation = makeSimulation(test::kettleStory(0.0).scene, Precision::kFloat, 1);
  std::vector<std::uint64_t> hashes{simulation->stateHash()};
  simulation->setGravity({0, 0, -5});
  hashes.push_back(simulation->stateHash());
  simulation->setTemperature(50, 10);
  hashes.push_back(simulation->stateHash());
  simulation->setTemperature(50, 10, "floor");
  hashes.push_back(simulation->stateHash());
  simulation->heatRegion({BlockShape::kSphere, Vec3d::Zero(), Vec3d::Ones(), 10.0, 1.0});
  hashes.push_back(simulation->stateHash());
  simulation->moveCollider("pot", poseOf({0.1, 0, 0}, Vec3d::Zero()));
  hashes.push_back(simulation->stateHash());
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end());
}

/// Files of another layout must not be accepted: the sizes of two states.
TEST(CheckpointTest, AChangedLayoutNeedsANewVersion) {
  const auto sizeOf = [](const Scene& scene) {
    return test::stateOf(*makeSimulation(scene, Precision::kFloat, 1)).size();
  };
  const char* const cure =
      "raise kVersion in src/core/checkpoint/checkpoint.cpp, then update this size";
  EXPECT_EQ(sizeOf(fullTank(2)), 1499U) << cure;
  EXPECT_EQ(sizeOf(test::hailStory().scene), 76200U) << cure;
}

}  // namespace checkpoint_test
}  // namespace ice_ice_baby
