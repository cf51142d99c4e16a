// What enters and leaves vessels and gauges: against a count of every particle in every frame, with
// vessels that move and tilt, particles that come and go, and any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "fixtures.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace vessel_flows_test {

/// Water splashes in a tank in which a cup scoops; gauges overlap both.
const std::string kScoop = R"(
fluid: {spacing_m: 0.03}
solver: {coarse_level: false}
bounds: {min_m: [-2, -2, -0.5], max_m: [2, 2, 2]}
containers: [{name: tank, size_m: [1, 0.6, 0.5]}]
cups: [{name: cup, radius_m: 0.12, depth_m: 0.2, wall_m: 0.03, position_m: [0.2, 0, 0.3]}]
blocks: [{min_m: [-0.48, -0.24, 0.03], max_m: [-0.06, 0.24, 0.39], velocity_m_s: [1, 0, 1]}]
gauges:
  - {name: left, position_m: [-0.25, 0, 0.2], size_m: [0.5, 0.6, 0.4], rpy_deg: [0, 0, 20]}
  - {name: above, position_m: [0, 0, 0.3], size_m: [0.3, 0.3, 0.3], frame: cup}
)";

/// A box or a cylinder, as the scene has it.
struct Space {
  std::string name, frame;
  Vec3d low, high;
  Posed in_frame;
  bool round;

  bool holds(const Simulation& simulation, const Vec3d& x) const {
    const Vec3d in_collider = frame.empty() ? x : simulation.colliderPose(frame).toLocal(x);
    const Vec3d p = in_frame.toLocal(in_collider);
    const bool in_box = (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
    return in_box && (!round || p.head<2>().norm() <= high.x());
  }
};

/// Innermost first, then the gauges.
std::vector<Space> spacesOf() {
  return {{"cup", "cup", {-0.12, -0.12, 0}, {0.12, 0.12, 0.2}, {}, true},
          {"tank", "tank", {-0.5, -0.3, 0}, {0.5, 0.3, 0.5}, {}, false},
          {"left",
           "",
           {-0.25, -0.3, -0.2},
           {0.25, 0.3, 0.2},
           poseOf({-0.25, 0, 0.2}, {0, 0, 20}),
           false},
          {"above",
           "cup",
           {-0.15, -0.15, -0.15},
           {0.15, 0.15, 0.15},
           poseOf({0, 0, 0.3}, {0, 0, 0}),
           false}};
}

/// Ids of the particles in each vessel and gauge; "": in no vessel.
std::map<std::string, std::set<std::uint32_t>> membersOf(const Simulation& simulation) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  std::map<std::string, std::set<std::uint32_t>> members;
  const std::vector<Space> spaces = spacesOf();
  for (const ParticleSample& p : particles) {
    const Vec3d x(p.x, p.y, p.z);
    const auto in = [&](std::size_t k) { return spaces[k].holds(simulation, x); };
    members[in(0) ? "cup" : in(1) ? "tank" : ""].insert(p.id);
    if (in(2)) members["left"].insert(p.id);
    if (in(3)) members["above"].insert(p.id);
  }
  return members;
}

/// Before a frame: the cup dives, tilts and rises; a tap runs and a drain takes.
void act(Simulator<float>& simulator, int frame) {
  const double t = frame / 60.0;
  simulator.moveCollider("cup",
                         poseOf({0.2 - 0.2 * std::sin(3 * t), 0, 0.3 - 0.2 * std::sin(4 * t)},
                                {0, 50 * std::sin(5 * t), 0}));
  if (frame % 5 == 2) {
    const auto drops =
        test::lattice(2, 0.03, simulator.colliderPose("cup").position + Vec3d(-0.03, -0.03, 0.6));
    simulator.addParticles(drops, std::vector<Vec3d>(drops.size(), Vec3d(0, 0, -2)), 20.0);
  }
  if (frame == 30) {
    simulator.removeParticles([](std::uint32_t id, const Vec3d&) { return id % 11 == 3; });
  }
}

TEST(VesselFlowsTest, EveryNumberIsThatOfACountOfParticlesInEveryFrame) {
  Simulator<float> simulator(parseScene(kScoop), 1);
  simulator.countFlows(true);
  const double particle_m3 = std::pow(0.03, 3);
  auto before = membersOf(simulator);
  std::map<std::string, double> entered, left;
  for (int frame = 0; frame < 60; ++frame) {
    act(simulator, frame);
    simulator.advanceFrame();
    auto now = membersOf(simulator);
    std::size_t all = now[""].size();
    for (const VesselReport& vessel : simulator.vessels()) {
      const std::set<std::uint32_t>& inside = now[vessel.name];
      ASSERT_EQ(vessel.particles, inside.size()) << vessel.name << " in frame " << frame;
      ASSERT_NEAR(vessel.water_m3, double(inside.size()) * particle_m3, 1e-12);
      if (vessel.name == "cup" || vessel.name == "tank") all += inside.size();
      const double change = vessel.entered_m3 - vessel.left_m3;
      const double since = double(inside.size()) - double(before[vessel.name].size());
      ASSERT_NEAR(change / particle_m3, since, 1e-6) << vessel.name << " in frame " << frame;
      ASSERT_GE(vessel.entered_m3, entered[vessel.name]);
      ASSERT_GE(vessel.left_m3, left[vessel.name]);
      entered[vessel.name] = vessel.entered_m3;
      left[vessel.name] = vessel.left_m3;
    }
    ASSERT_EQ(all, simulator.report().particles);
  }
  for (const auto& [name, volume_m3] : entered) {
    EXPECT_GT(volume_m3, 0.0) << name;
    EXPECT_GT(left[name], 0.0) << name;
  }
  EXPECT_GT(simulator.report().spilled, 0U)
      << "so that particles which leave the scene are counted";
}

TEST(VesselFlowsTest, TotalsAreTheSumOfWhatChangedInEachFrame) {
  Simulator<float> simulator(parseScene(kScoop), 1);
  simulator.countFlows(true);
  auto before = membersOf(simulator);
  std::map<std::string, int> entered, left;
  for (int frame = 0; frame < 40; ++frame) {
    simulator.advanceFrame();
    auto now = membersOf(simulator);
    for (const char* name : {"cup", "tank", "left", "above"}) {
      for (const std::uint32_t id : now[name]) entered[name] += int(before[name].count(id) == 0);
      for (const std::uint32_t id : before[name]) left[name] += int(now[name].count(id) == 0);
    }
    before = now;
  }
  for (const VesselReport& vessel : simulator.vessels()) {
    EXPECT_NEAR(vessel.entered_m3 / std::pow(0.03, 3), entered[vessel.name], 1e-6) << vessel.name;
    EXPECT_NEAR(vessel.left_m3 / std::pow(0.03, 3), left[vessel.name], 1e-6) << vessel.name;
  }
  EXPECT_GT(left["left"], 0);
}

TEST(VesselFlowsTest, HaveTheSameBitsOnOneTwoAndFourThreads) {
  std::vector<std::vector<double>> numbers;
  for (const int threads : {1, 2, 4}) {
    Simulator<float> simulator(parseScene(kScoop), threads);
    simulator.countFlows(true);
    std::vector<double>& list = numbers.emplace_back();
    for (int frame = 0; frame < 25; ++frame) {
      act(simulator, frame);
      simulator.advanceFrame();
      for (const VesselReport& vessel : simulator.vessels()) {
        describeVessel(
            [&](const std::string& name, const auto& value, const char*) {
              if (name != "mean_celsius") list.push_back(double(value));
            },
            vessel);
      }
    }
  }
  EXPECT_EQ(numbers[0], numbers[1]);
  EXPECT_EQ(numbers[0], numbers[2]);
}

TEST(VesselFlowsTest, CountingChangesNoBitOfTheSimulation) {
  Simulator<float> counted(parseScene(kScoop), 1), plain(parseScene(kScoop), 1);
  counted.countFlows(true);
  for (int frame = 0; frame < 15; ++frame) {
    act(counted, frame);
    act(plain, frame);
    counted.advanceFrame();
    counted.vessels();
    plain.advanceFrame();
  }
  EXPECT_EQ(counted.stateHash(), plain.stateHash());
}

/// A bar of water flies through a gauge: 0.2 m x 0.2 m at 1 m/s.
TEST(VesselFlowsTest, TheRatesAreThoseOfAKnownStream) {
  const Scene scene = parseScene(R"(
gravity_m_s2: [0, 0, 0]
fluid: {spacing_m: 0.02}
blocks: [{min_m: [-1, -0.1, -0.1], max_m: [0, 0.1, 0.1], velocity_m_s: [1, 0, 0]}]
gauges: [{name: window, position_m: [0.105, 0, 0], size_m: [0.2, 0.4, 0.4]}]
)");
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  simulation->countFlows(true);
  for (int frame = 0; frame < 48; ++frame) simulation->advanceFrame();
  const VesselReport window = simulation->vessels().at(0);
  EXPECT_NEAR(window.inflow_m3_s, 0.04, 0.04 * 0.04);  // one layer of 25 in half a second
  EXPECT_NEAR(window.outflow_m3_s, 0.04, 0.04 * 0.04);
  EXPECT_NEAR(window.entered_m3, 0.04 * 0.8, 0.04 * 0.02);
  EXPECT_NEAR(window.left_m3, 0.04 * 0.6, 0.04 * 0.02);
}

TEST(VesselFlowsTest, AreCountedOnlyOnDemandAndNotWithoutVessels) {
  const auto countsStage = [](const Simulation& simulation) {
    int found = 0;
    for (const StageStats& stage : simulation.stages()) found += stage.name == "vessels";
    return found;
  };
  const auto simulation = makeSimulation(parseScene(kScoop), Precision::kFloat, 1);
  simulation->advanceFrame();
  EXPECT_EQ(countsStage(*simulation), 0);
  simulation->countFlows(true);
  for (int frame = 0; frame < 20; ++frame) simulation->advanceFrame();
  EXPECT_EQ(countsStage(*simulation), 1);
  EXPECT_GT(simulation->vessels()[2].left_m3, 0.0);
  simulation->countFlows(true);  // goes on
  EXPECT_GT(simulation->vessels()[2].left_m3, 0.0);
  simulation->countFlows(false);
  EXPECT_EQ(simulation->vessels()[2].left_m3, 0.0);
  EXPECT_EQ(countsStage(*simulation), 0);
  const auto without = makeSimulation(test::floatingCube(3), Precision::kFloat, 1);
  without->countFlows(true);
  without->advanceFrame();
  EXPECT_EQ(countsStage(*without), 0);
}

}  // namespace vessel_flows_test
}  // namespace ice_ice_baby
