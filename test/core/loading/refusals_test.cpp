// Everything that the simulation refuses: thing, value and range are named, and no bit of the state
// has changed.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

struct Refused {
  std::string what;
  std::function<void(Simulation&)> call;
  std::vector<std::string> words;  ///< thing, value, range
};

HeatedRegion region(const Vec3d& centre_m, const Vec3d& size_m, double power_w, double duration_s) {
  return {BlockShape::kSphere, centre_m, size_m, power_w, duration_s};
}

Posed turned(const Mat3<double>& rotation) {
  Posed pose;
  pose.rotation = rotation;
  return pose;
}

Posed at(const Vec3d& position_m) {
  Posed pose;
  pose.position = position_m;
  return pose;
}

HeatedRegion cylinder() {
  HeatedRegion heated;
  heated.shape = BlockShape::kCylinder;
  return heated;
}

std::vector<Refused> temperatures() {
  const std::string range = "[-273.15, 1000]", thing = "temperature in degrees Celsius = ";
  return {
      {"too hot", [](Simulation& s) { s.setTemperature(1000.5, 0); }, {thing + "1000.5", range}},
      {"too cold", [](Simulation& s) { s.setTemperature(-274, 0); }, {thing + "-274", range}},
      {"nan", [](Simulation& s) { s.setTemperature(-kNan, 0); }, {thing + "nan", range}},
      {"inf", [](Simulation& s) { s.setTemperature(kInf, 0); }, {thing + "inf", range}},
      {"ramp",
       [](Simulation& s) { s.setTemperature(0, -1); },
       {"ramp in seconds = -1", "[0, 1e+06]"}},
      {"long ramp", [](Simulation& s) { s.setTemperature(0, 2e6); }, {"2e+06", "[0, 1e+06]"}},
      {"target",
       [](Simulation& s) { s.setTemperature(0, 0, "pan"); },
       {"no collider \"pan\"", "tank"}},
      {"target of a line", [](Simulation& s) { s.setTemperature(0, 0, "a\nb"); }, {"\"a\\x0ab\""}},
  };
}

std::vector<Refused> regions() {
  const Vec3d zero = Vec3d::Zero(), one = Vec3d::Ones();
  const auto heat = [](const HeatedRegion& r) { return [r](Simulation& s) { s.heatRegion(r); }; };
  return {
      {"shape", heat(cylinder()), {"box or a sphere", "cylinder"}},
      {"centre", heat(region({0, kNan, 0}, one, 1, 1)), {"centre y", "nan", "[-100, 100]"}},
      {"far", heat(region({0, 0, 101}, one, 1, 1)), {"centre z", "101", "[-100, 100]"}},
      {"size", heat(region(zero, {-1, 1, 1}, 1, 1)), {"size x", "-1", "[0, 200]"}},
      {"power", heat(region(zero, one, 2e9, 1)), {"power in watts = 2e+09", "[-1e+09, 1e+09]"}},
      {"no power", heat(region(zero, one, kNan, 1)), {"power in watts = nan"}},
      {"duration", heat(region(zero, one, 1, -1)), {"duration in seconds = -1", "[0, 1e+06]"}},
  };
}

std::vector<Refused> motions() {
  const Mat3<double> one = Mat3<double>::Identity();
  const auto move = [](const std::string& name, const Posed& pose) {
    return [=](Simulation& s) { s.moveCollider(name, pose); };
  };
  return {
      {"gravity",
       [](Simulation& s) {
         s.setGravity({0, 0, 1.1e4});
       },
       {"gravity z", "11000", "[-10000, 10000]"}},
      {"no gravity",
       [](Simulation& s) {
         s.setGravity({kNan, 0, 0});
       },
       {"gravity x", "nan"}},
      {"nobody of two lines", move("p\nn", at({0, 0, 0})), {"p\\x0an"}},
      {"nobody", move("pan", at({0, 0, 0})), {"pan", "tank"}},
      {"far", move("tank", at({0, 101, 0})), {"position of collider tank", "101", "[-100, 100]"}},
      {"nowhere", move("tank", at({kInf, 0, 0})), {"position of collider tank", "inf"}},
      {"no turn", move("tank", turned(0 * one)), {"rotation of collider tank", "unit quaternion"}},
      {"mirror", move("tank", turned(-one)), {"rotation of collider tank", "unit quaternion"}},
      {"sheared", move("tank", turned(1.001 * one)), {"rotation of collider tank"}},
      {"nan turn", move("tank", turned(kNan * one)), {"rotation of collider tank"}},
      {"pose of nobody", [](Simulation& s) { s.colliderPose("pan"); }, {"pan", "tank"}},
  };
}

Scene warmTank() {
  Scene scene = test::fullTank(4);
  scene.thermal.enabled = true;
  scene.containers[0].size_m.z() *= 2;
  return scene;
}

std::vector<Refused> all() {
  std::vector<Refused> cases = temperatures();
  for (const auto& more : {regions(), motions()})
    cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

TEST(Refusals, NameThingValueAndRangeAndChangeNoBit) {
  const auto simulation = makeSimulation(warmTank(), Precision::kFloat, 1);
  const auto untouched = makeSimulation(warmTank(), Precision::kFloat, 1);
  simulation->advanceFrame();
  untouched->advanceFrame();
  for (const Refused& refused : all()) {
    const std::uint64_t before = simulation->stateHash();
    try {
      refused.call(*simulation);
      ADD_FAILURE() << refused.what << " was accepted";
    } catch (const InvalidInput& e) {
      for (const std::string& word : refused.words) {
        EXPECT_NE(std::string(e.what()).find(word), std::string::npos)
            << refused.what << ": \"" << word << "\" not in: " << e.what();
      }
    }
    EXPECT_EQ(simulation->stateHash(), before) << refused.what;
  }
  // What a hash of the particles does not hold, as gravity and poses, shows in the frames to come.
  for (int frame = 0; frame < 5; ++frame) {
    simulation->advanceFrame();
    untouched->advanceFrame();
  }
  EXPECT_EQ(simulation->stateHash(), untouched->stateHash());
}

TEST(Refusals, OfHeatWithoutHeatSayWhatItNeeds) {
  const auto simulation = makeSimulation(test::fullTank(3), Precision::kFloat, 1);
  const std::uint64_t before = simulation->stateHash();
  EXPECT_THROW(simulation->heatRegion(region({0, 0, 0}, {1, 1, 1}, 1, 1)), InvalidInput);
  EXPECT_THROW(simulation->setTemperature(0, 0, "tank"), InvalidInput);
  EXPECT_EQ(simulation->stateHash(), before);
}

TEST(Refusals, OneRegionTooManyIsNamed) {
  const auto simulation = makeSimulation(warmTank(), Precision::kFloat, 1);
  const HeatedRegion heated = region({0, 0, 0}, {1, 1, 1}, 1, 1e6);
  for (std::size_t k = 0; k < kMaxHeatedRegions; ++k) simulation->heatRegion(heated);
  try {
    simulation->heatRegion(heated);
    FAIL() << "accepted";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("100 regions"), std::string::npos) << e.what();
  }
}

TEST(Refusals, OfAThreadCountBeforeAnythingIsMade) {
  for (const int threads : {-1, 1025}) {
    EXPECT_THROW(makeSimulation(test::fullTank(2), Precision::kFloat, threads), InvalidInput);
  }
}

}  // namespace
}  // namespace ice_ice_baby
