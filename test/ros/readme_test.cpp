// Calls of services in README.md work on the scenes that it names.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace {

/// The line of README.md with the call that sets the temperature of a collider.
std::string targetLine() {
  std::ifstream readme(IIB_README);
  for (std::string line; std::getline(readme, line);) {
    if (line.find("set_temperature \"{temperature: ") == std::string::npos) continue;
    if (line.find("target: ") != std::string::npos) return line;
  }
  ADD_FAILURE() << "no such call in " IIB_README;
  return "";
}

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    found.insert((*match)[1]);
  }
  return found;
}

std::string targetOfReadme() { return *matches(targetLine(), "target: ([a-z_]+)").begin(); }

TEST(Readme, TemperatureOfAColliderWorksInTheSceneThatItNames) {
  const std::vector<std::string> names = sceneNames();
  std::set<std::string> scenes;
  for (const std::string& word : matches(targetLine(), "`([a-z_]+)`")) {
    if (std::find(names.begin(), names.end(), word) != names.end()) scenes.insert(word);
  }
  ASSERT_EQ(scenes.size(), 1u) << targetLine();
  const Scene scene = loadScene(*scenes.begin());
  EXPECT_NO_THROW(requireTarget(scene, targetOfReadme()));
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  EXPECT_NO_THROW(simulation->setTemperature(60.0, 2.0, targetOfReadme()));
}

TEST(Readme, TemperatureOfAColliderElsewhereSaysWhichCollidersThereAre) {
  int with_heat = 0;
  for (const std::string& name : sceneNames()) {
    const Scene scene = loadScene(name);
    std::string why;
    try {
      requireTarget(scene, "container of nobody");
    } catch (const InvalidInput& e) {
      why = e.what();
    }
    EXPECT_NE(why.find("\"container of nobody\""), std::string::npos) << why;
    EXPECT_NE(why.find(name), std::string::npos) << why;
    if (!scene.thermal.enabled) {
      EXPECT_NE(why.find("thermal.enabled: true, as iceberg"), std::string::npos) << why;
      continue;
    }
    ++with_heat;
    forEachCollider(scene, [&](const Collider& collider) {
      EXPECT_NE(why.find(collider.name), std::string::npos) << why;
      EXPECT_NO_THROW(requireTarget(scene, collider.name)) << name;
    });
  }
  EXPECT_GE(with_heat, 8);
}

}  // namespace
}  // namespace ice_ice_baby
