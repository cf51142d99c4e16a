// Commands between frames: none is lost or applied in part, and none waits for the solver.
#include "simulation_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {
namespace {

Scene puddle() {
  return parseScene(R"(
    fluid: {spacing_m: 0.05}
    blocks: [{min_m: [0, 0, 0.2], max_m: [0.2, 0.2, 0.4]}]
    planes: [{name: ground}])");
}

Scene warmPuddle() {
  Scene scene = puddle();
  scene.thermal.enabled = true;
  return scene;
}

HeatedRegion torch() {
  HeatedRegion region;
  region.size_m = {0.2, 0.2, 0.2};
  region.power_w = 500.0;
  region.duration_s = 1.0;
  return region;
}

RunOptions paused() {
  RunOptions options;
  options.threads = 1;
  options.start_paused = true;
  return options;
}

template <class Condition>
bool becomes(const SimulationThread& thread, const Condition& condition) {
  for (int k = 0; k < 1000; ++k) {
    if (condition(thread.snapshot())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

bool reaches(const SimulationThread& thread, std::uint64_t frame) {
  return becomes(thread, [&](const Snapshot& now) { return now.report.frame == frame; });
}

TEST(SimulationThread, StepsExactlyAsManyFramesAsAsked) {
  SimulationThread thread(puddle(), paused(), {});
  EXPECT_EQ(thread.snapshot().report.particles, 64u);
  thread.step(7);
  ASSERT_TRUE(reaches(thread, 7));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(thread.snapshot().report.frame, 7u);
  EXPECT_NEAR(thread.snapshot().simulated_s, 7 / 60.0, 1e-12);
}

TEST(SimulationThread, StepsOnlyWhilePaused) {
  SimulationThread thread(puddle(), paused(), {});
  EXPECT_THROW(thread.step(0), InvalidInput);
  EXPECT_THROW(thread.step(100001), InvalidInput);
  thread.resume();
  EXPECT_THROW(thread.step(1), InvalidInput);
  thread.pause();
  EXPECT_NO_THROW(thread.step(1));
}

TEST(SimulationThread, RefusedCommandsChangeNothing) {
  SimulationThread thread(puddle(), paused(), {});
  EXPECT_THROW(thread.setTemperature(std::nan(""), 0.0), InvalidInput);
  EXPECT_THROW(thread.setTemperature(-300.0, 0.0), InvalidInput);
  EXPECT_THROW(thread.setTemperature(0.0, -1.0), InvalidInput);
  EXPECT_THROW(thread.setGravity({0.0, INFINITY, 0.0}), InvalidInput);
  thread.step(1);
  ASSERT_TRUE(reaches(thread, 1));
  EXPECT_EQ(thread.snapshot().report.temperature_c, 20.0);
  EXPECT_EQ(thread.snapshot().gravity_m_s2, Vec3d(0.0, 0.0, -9.81));
}

TEST(SimulationThread, TargetsAndRegionsNeedHeat) {
  SimulationThread thread(puddle(), paused(), {});
  EXPECT_THROW(thread.setTemperature(-5.0, 0.0, "ground"), InvalidInput);
  EXPECT_THROW(thread.heatRegion(torch()), InvalidInput);
  EXPECT_FALSE(thread.snapshot().thermal);
  EXPECT_EQ(thread.snapshot().colliders, std::vector<std::string>{"ground"});
}

TEST(SimulationThread, TargetsAndRegionsAreCheckedBeforeTheyAreQueued) {
  SimulationThread thread(warmPuddle(), paused(), {});
  EXPECT_NO_THROW(thread.setTemperature(-5.0, 0.0, "ground"));
  EXPECT_NO_THROW(thread.heatRegion(torch()));
  EXPECT_THROW(thread.setTemperature(-5.0, 0.0, "grond"), InvalidInput);
  HeatedRegion endless = torch();
  endless.duration_s = INFINITY;
  EXPECT_THROW(thread.heatRegion(endless), InvalidInput);
  thread.step(1);
  ASSERT_TRUE(reaches(thread, 1));
  EXPECT_TRUE(thread.snapshot().thermal);
  EXPECT_EQ(thread.snapshot().refused, 0u);
}

TEST(SimulationThread, CommandsActOnTheSceneOfTheResetBeforeThem) {
  SimulationThread thread(puddle(), paused(), {});
  thread.reset(warmPuddle());
  EXPECT_NO_THROW(thread.setTemperature(-5.0, 0.0, "ground"));
  thread.reset(puddle());
  EXPECT_THROW(thread.heatRegion(torch()), InvalidInput);
  thread.step(1);
  ASSERT_TRUE(reaches(thread, 1));
  EXPECT_EQ(thread.snapshot().refused, 0u);
}

TEST(SimulationThread, CommandThatNoLongerFitsChangesNothingAndIsReported) {
  std::atomic<bool> held{true};
  RunHooks hooks;
  hooks.started = [&](const Simulation&) {
    while (held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  SimulationThread thread(puddle(), paused(), hooks);
  Scene impossible = warmPuddle();
  impossible.limits.max_particles = 1;
  thread.reset(impossible);
  thread.setTemperature(-5.0, 0.0, "ground");  // accepted: the reset may succeed
  thread.heatRegion(torch());
  thread.step(1);
  held = false;
  ASSERT_TRUE(reaches(thread, 1));
  EXPECT_EQ(thread.snapshot().refused, 3u);
  EXPECT_NE(thread.snapshot().refusal.find("thermal.enabled"), std::string::npos);
  EXPECT_EQ(thread.snapshot().report.temperature_c, 20.0);
  EXPECT_THROW(thread.heatRegion(torch()), InvalidInput);  // the old scene counts again
}

TEST(SimulationThread, ResetThatFailsKeepsTheOldSimulation) {
  SimulationThread thread(puddle(), paused(), {});
  thread.step(3);
  ASSERT_TRUE(reaches(thread, 3));
  Scene impossible = puddle();
  impossible.limits.max_particles = 1;
  thread.reset(impossible);
  thread.step(1);
  EXPECT_TRUE(reaches(thread, 4));
  EXPECT_EQ(thread.snapshot().report.particles, 64u);
}

TEST(SimulationThread, ResetStartsAgainAndCallsTheHook) {
  std::atomic<int> starts{0};
  RunHooks hooks;
  hooks.started = [&](const Simulation&) { ++starts; };
  SimulationThread thread(puddle(), paused(), hooks);
  thread.setTemperature(-5.0, 0.0);
  thread.step(3);
  ASSERT_TRUE(reaches(thread, 3));
  thread.reset(puddle());
  ASSERT_TRUE(reaches(thread, 0));
  EXPECT_EQ(thread.snapshot().report.temperature_c, 20.0);
  EXPECT_EQ(thread.snapshot().report.springs, 0u);
  EXPECT_TRUE(becomes(thread, [&](const Snapshot&) { return starts == 2; }));
}

TEST(SimulationThread, FrameThatFailsPausesInsteadOfEndingTheNode) {
  RunHooks hooks;
  std::atomic<bool> fails{true};
  hooks.before_frame = [&](Simulation&, const FrameBegin&) {
    if (fails) throw std::runtime_error("out of luck");
  };
  RunOptions options = paused();
  options.start_paused = false;
  SimulationThread thread(puddle(), options, hooks);
  ASSERT_TRUE(becomes(thread, [](const Snapshot& now) { return now.paused; }));
  EXPECT_EQ(thread.snapshot().failure, "out of luck");
  fails = false;
  thread.resume();
  EXPECT_TRUE(becomes(thread, [](const Snapshot& now) { return now.report.frame > 2; }));
  EXPECT_EQ(thread.snapshot().failure, "");
}

/// Holds the simulation thread at its start until released.
struct Gate {
  RunHooks hooks() {
    RunHooks hooks;
    hooks.started = [this](const Simulation&) {
      while (held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    return hooks;
  }

  std::atomic<bool> held{true};
};

TEST(SimulationThread, CommandsInTheQueueAreLimited) {
  Gate gate;
  SimulationThread thread(puddle(), paused(), gate.hooks());
  for (int k = 0; k < 1000; ++k) thread.setTemperature(k % 50, 0.0);
  EXPECT_THROW(thread.setTemperature(1.0, 0.0), InvalidInput);
  gate.held = false;
  EXPECT_TRUE(becomes(thread, [](const Snapshot& now) { return now.report.temperature_c == 49; }));
}

TEST(SimulationThread, PauseAndResumeFitIntoAFullQueue) {
  Gate gate;
  RunOptions running = paused();
  running.start_paused = false;
  SimulationThread thread(puddle(), running, gate.hooks());
  for (int k = 0; k < 1000; ++k) thread.setTemperature(-5.0, 0.0);
  EXPECT_THROW(thread.setTemperature(-5.0, 0.0), InvalidInput);
  for (int k = 0; k < 5000; ++k) {
    thread.resume();
    thread.pause();
  }
  gate.held = false;
  ASSERT_TRUE(becomes(thread, [](const Snapshot& now) { return now.paused; }));
  EXPECT_EQ(thread.snapshot().changes, 1001u);  // those in a row counted as one
  EXPECT_EQ(thread.snapshot().report.frame, 0u);
  EXPECT_EQ(thread.snapshot().report.temperature_c, -5.0);
}

TEST(SimulationThread, ResetThatFailsKeepsWhereTheSceneCameFrom) {
  SimulationThread thread({puddle(), "puddle"}, paused(), {});
  Scene impossible = puddle();
  impossible.limits.max_particles = 1;
  thread.reset({impossible, "impossible"});
  ASSERT_TRUE(becomes(thread, [](const Snapshot& now) { return now.refused == 1; }));
  EXPECT_EQ(thread.comingScene()->source, "puddle");
  thread.reset({warmPuddle(), "warm"});
  EXPECT_EQ(thread.comingScene()->source, "warm");
}

TEST(SimulationThread, PausedStateHasAHash) {
  SimulationThread thread(puddle(), paused(), {});
  const auto hashed = [](const Snapshot& now) { return now.state_hash != 0; };
  ASSERT_TRUE(becomes(thread, hashed));
  const std::uint64_t start = thread.snapshot().state_hash;
  thread.step(5);
  ASSERT_TRUE(becomes(
      thread, [&](const Snapshot& now) { return now.report.frame == 5 && now.state_hash != 0; }));
  EXPECT_NE(thread.snapshot().state_hash, start);
  thread.reset(puddle());
  EXPECT_TRUE(becomes(thread, [&](const Snapshot& now) { return now.state_hash == start; }));
  thread.resume();
  EXPECT_TRUE(becomes(
      thread, [](const Snapshot& now) { return now.report.frame > 0 && now.state_hash == 0; }));
}

TEST(SimulationThread, ContinuesALoadedSimulation) {
  std::atomic<int> starts{0};
  RunHooks hooks;
  hooks.started = [&](const Simulation&) { ++starts; };
  SimulationThread thread({puddle(), "puddle"}, paused(), hooks);
  std::unique_ptr<Simulation> other = makeSimulation(warmPuddle(), Precision::kDouble, 1);
  for (int k = 0; k < 3; ++k) other->advanceFrame();
  const std::uint64_t hash = other->stateHash();
  thread.load(std::move(other));
  EXPECT_EQ(thread.comingScene()->source, "");
  ASSERT_TRUE(becomes(thread, [&](const Snapshot& now) { return now.state_hash == hash; }));
  EXPECT_EQ(thread.snapshot().report.frame, 3u);
  EXPECT_EQ(thread.snapshot().precision, Precision::kDouble);
  EXPECT_TRUE(thread.snapshot().thermal);
  EXPECT_NO_THROW(thread.setTemperature(-5.0, 0.0, "ground"));
  EXPECT_TRUE(becomes(thread, [&](const Snapshot& now) {
    return starts == 2 && now.state_hash != 0 && now.state_hash != hash;
  }));
}

TEST(SimulationThread, InspectSeesACompleteFrameAndChangesNothing) {
  SimulationThread thread(puddle(), paused(), {});
  thread.step(2);
  ASSERT_TRUE(reaches(thread, 2));
  const std::uint64_t changes = thread.snapshot().changes;
  std::atomic<std::uint64_t> seen{0};
  thread.inspect([&](const Simulation& simulation) { seen = simulation.report().frame; });
  ASSERT_TRUE(becomes(thread, [&](const Snapshot&) { return seen == 2; }));
  EXPECT_EQ(thread.snapshot().changes, changes);
}

TEST(SimulationThread, StopDoesNotWaitForALongFrame) {
  std::atomic<bool> held{true};
  RunHooks hooks;
  hooks.started = [&](const Simulation&) {
    while (held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  SimulationThread thread(puddle(), paused(), hooks);
  EXPECT_FALSE(thread.stop(0.05));
  held = false;
  EXPECT_TRUE(thread.stop(5.0));
}

TEST(SimulationThread, HoldsTheRealTimeFactor) {
  RunOptions options = paused();
  options.start_paused = false;
  options.real_time_factor = 0.5;
  SimulationThread thread(puddle(), options, {});
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  const Snapshot now = thread.snapshot();
  EXPECT_LE(now.simulated_s, 0.55);
  EXPECT_GT(now.simulated_s, 0.2);
}

/// After the first frame, how much time is simulated while `command` is given again and again, the
/// next frame not being due for a quarter of a minute.
template <class Command>
double simulatedUnder(const Command& command) {
  RunOptions options = paused();
  options.start_paused = false;
  options.real_time_factor = 0.001;
  SimulationThread thread(puddle(), options, {});
  EXPECT_TRUE(becomes(thread, [](const Snapshot& now) { return now.simulated_s > 0.0; }));
  const double first_s = thread.snapshot().simulated_s;
  for (int k = 0; k < 10; ++k) {
    const std::uint64_t changes = thread.snapshot().changes;
    command(thread);
    EXPECT_TRUE(becomes(thread, [&](const Snapshot& now) { return now.changes > changes; }));
  }
  return thread.snapshot().simulated_s - first_s;
}

TEST(SimulationThread, NoCommandHurriesTheFrames) {
  EXPECT_EQ(simulatedUnder([](SimulationThread& thread) { thread.resume(); }), 0.0);
  EXPECT_EQ(simulatedUnder([](SimulationThread& thread) { thread.reset(puddle()); }), 0.0);
  EXPECT_EQ(simulatedUnder([](SimulationThread& thread) {
              thread.pause();
              EXPECT_TRUE(becomes(thread, [](const Snapshot& now) { return now.paused; }));
              thread.resume();
              EXPECT_TRUE(becomes(thread, [](const Snapshot& now) { return !now.paused; }));
            }),
            0.0);
}

}  // namespace
}  // namespace ice_ice_baby
