// Every command that a simulation refuses: the message names thing, value and range, and the state
// stays as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace refusals_test {

using namespace std::string_literals;

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

/// Zero but for one component, so that an infinite one leaves the others finite.
Vec3d along(int axis, double value) {
  Vec3d vector = Vec3d::Zero();
  vector[axis] = value;
  return vector;
}

HeatedRegion cylinder() {
  HeatedRegion heated;
  heated.shape = BlockShape::kCylinder;
  return heated;
}

/// Values outside a range, not-a-number and the infinities, with the text that messages show.
std::vector<std::pair<double, std::string>> outOfRange(double below, double above) {
  return {{below, numberText(below)},
          {above, numberText(above)},
          {-kNan, "nan"},
          {kInf, "inf"},
          {-kInf, "-inf"}};
}

std::vector<Refused> temperatures() {
  const std::string range = "[-273.15, 1000]", thing = "temperature in degrees Celsius = ";
  const std::string ramp = "ramp in seconds = ", ramp_range = "[0, 1e+06]";
  std::vector<Refused> cases;
  for (const char* target : {"", "tank"}) {
    const auto set = [=](double celsius, double ramp_s) {
      return [=](Simulation& s) { s.setTemperature(celsius, ramp_s, target); };
    };
    for (const auto& [bad, text] : outOfRange(-273.2, 1000.5)) {
      cases.push_back({"temperature", set(bad, 0), {thing + text, range}});
    }
    for (const auto& [bad, text] : outOfRange(-1, 2e6)) {
      cases.push_back({"ramp", set(0, bad), {ramp + text, ramp_range}});
    }
  }
  const auto target = [](const char* name) {
    return [=](Simulation& s) { s.setTemperature(0, 0, name); };
  };
  cases.push_back({"unknown target", target("pan"), {"no collider \"pan\"", "tank"}});
  cases.push_back({"target of two lines", target("a\nb"), {"\"a\\x0ab\""}});
  return cases;
}

std::vector<Refused> regions() {
  const Vec3d zero = Vec3d::Zero(), one = Vec3d::Ones();
  const auto heat = [](const HeatedRegion& r) { return [r](Simulation& s) { s.heatRegion(r); }; };
  std::vector<Refused> cases = {
      {"shape", heat(cylinder()), {"box or a sphere", "cylinder"}},
      {"centre", heat(region({0, kNan, 0}, one, 1, 1)), {"centre y", "nan", "[-100, 100]"}},
      {"far", heat(region({0, 0, 101}, one, 1, 1)), {"centre z", "101", "[-100, 100]"}},
      {"size", heat(region(zero, {-1, 1, 1}, 1, 1)), {"size x", "-1", "[0, 200]"}},
  };
  for (const auto& [bad, text] : outOfRange(-1e10, 2e9)) {
    cases.push_back({"power",
                     heat(region(zero, one, bad, 1)),
                     {"power in watts = " + text, "[-1e+09, 1e+09]"}});
  }
  for (const auto& [bad, text] : outOfRange(-1, 1e10)) {
    cases.push_back({"duration",
                     heat(region(zero, one, 1, bad)),
                     {"duration in seconds = " + text, "[0, 1e+06]"}});
  }
  return cases;
}

std::vector<Refused> motions() {
  const Mat3<double> one = Mat3<double>::Identity();
  Mat3<double> bent = one;
  bent(0, 0) = kInf;
  const auto move = [](const std::string& name, const Posed& pose) {
    return [=](Simulation& s) { s.moveCollider(name, pose); };
  };
  const std::string rotation = "rotation of collider tank";
  std::vector<Refused> cases = {
      {"collider of two lines", move("p\nn", at({0, 0, 0})), {"p\\x0an"}},
      {"unknown collider", move("pan", at({0, 0, 0})), {"pan", "tank"}},
      {"zero rotation", move("tank", turned(0 * one)), {rotation, "unit quaternion"}},
      {"inversion", move("tank", turned(-one)), {rotation, "unit quaternion"}},
      {"mirror", move("tank", turned(Vec3d(1, 1, -1).asDiagonal())), {rotation, "unit quaternion"}},
      {"slightly enlarged", move("tank", turned(1.001 * one)), {rotation}},
      {"rotation of nan", move("tank", turned(kNan * one)), {rotation}},
      {"rotation with an infinity", move("tank", turned(bent)), {rotation}},
      {"pose of an unknown collider",
       [](Simulation& s) { s.colliderPose("pan"); },
       {"pan", "tank"}},
  };
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("gravity ") + "xyz"[axis];
    for (const auto& [bad, text] : outOfRange(-1.1e4, 1e5)) {
      const Vec3d vector = along(axis, bad);
      cases.push_back({"gravity",
                       [=](Simulation& s) { s.setGravity(vector); },
                       {name, text, "[-10000, 10000]"}});
    }
    for (const auto& [bad, text] : outOfRange(-101, 1e5)) {
      cases.push_back({"position",
                       move("tank", at(along(axis, bad))),
                       {"position of collider tank", text, "[-100, 100]"}});
    }
  }
  return cases;
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
    const std::string why = test::refusalOf([&] { refused.call(*simulation); });
    EXPECT_NE(why, "") << refused.what << " was accepted";
    for (const std::string& word : refused.words) {
      EXPECT_NE(why.find(word), std::string::npos)
          << refused.what << ": \"" << word << "\" not in: " << why;
    }
    EXPECT_EQ(simulation->stateHash(), before) << refused.what;
  }
  // Caches that follow from the state are not hashed, so the next frames must be the same too.
  for (int frame = 0; frame < 5; ++frame) {
    simulation->advanceFrame();
    untouched->advanceFrame();
  }
  EXPECT_EQ(simulation->stateHash(), untouched->stateHash());
}

TEST(Refusals, CommandsThatNeedHeatNameItsKeyWhereItIsOff) {
  const auto simulation = makeSimulation(test::fullTank(3), Precision::kFloat, 1);
  const std::uint64_t before = simulation->stateHash();
  const std::function<void()> commands[] = {
      [&] {
        simulation->heatRegion(region({0, 0, 0}, {1, 1, 1}, 1, 1));
      },
      [&] { simulation->setTemperature(0, 0, "tank"); }};
  for (const auto& command : commands) {
    EXPECT_NE(test::refusalOf(command).find("thermal.enabled"), std::string::npos);
  }
  EXPECT_EQ(simulation->stateHash(), before);
}

TEST(Refusals, OneRegionTooManyIsNamed) {
  const auto simulation = makeSimulation(warmTank(), Precision::kFloat, 1);
  const HeatedRegion heated = region({0, 0, 0}, {1, 1, 1}, 1, 1e6);
  for (std::size_t k = 0; k < kMaxHeatedRegions; ++k) simulation->heatRegion(heated);
  const std::string why = test::refusalOf([&] { simulation->heatRegion(heated); });
  EXPECT_NE(why.find("100 regions"), std::string::npos) << why;
}

TEST(Refusals, AThreadCountOutOfRangeIsNamed) {
  for (const int threads : {-1, 1025}) {
    const std::string why =
        test::refusalOf([&] { makeSimulation(test::fullTank(2), Precision::kFloat, threads); });
    for (const std::string& word : {"threads = " + std::to_string(threads), "[0, 1024]"s}) {
      EXPECT_NE(why.find(word), std::string::npos) << why;
    }
  }
}

}  // namespace refusals_test
}  // namespace ice_ice_baby
