// Scene files: refusals and their words, overrides and presets, and every shipped scene.
#include "ice_ice_baby/scene_loader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "fixtures.h"
#include "ice_ice_baby/simulation.h"
#include "metrics/escape_meter.h"

namespace ice_ice_baby {
namespace scene_loader_test {

namespace fs = std::filesystem;

/// Message of the refusal; "" if the text is accepted.
std::string refusal(const std::string& yaml, const std::vector<Override>& overrides = {}) {
  return test::refusalOf([&] { parseScene(yaml, overrides, "origin"); });
}

void expectRefusal(const std::string& yaml, const std::vector<std::string>& words,
                   const std::vector<Override>& overrides = {}) {
  const std::string message = refusal(yaml, overrides);
  EXPECT_NE(message, "") << yaml << " was accepted";
  EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
  for (const std::string& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << "\"" << word << "\" not in: " << message;
  }
}

TEST(SceneRefusalTest, UnknownKeysGetASuggestion) {
  expectRefusal("solver: {iteration: 4}", {"unknown key solver.iteration", "solver.iterations"});
  expectRefusal("gravity: [0, 0, -1]", {"unknown key gravity", "gravity_m_s2"});
  expectRefusal("spheres: [{radius: 1}]", {"spheres.0.radius", "radius_m"});
  expectRefusal("zzzzqqqq: 1", {"unknown key zzzzqqqq", "allowed: name, "});
}

TEST(SceneRefusalTest, ValuesOutOfRangeNameTheRange) {
  expectRefusal("fluid: {spacing_m: 0}", {"fluid.spacing_m = 0", "[1e-04, 10]"});
  expectRefusal("solver: {substeps: 1001}", {"solver.substeps", "[0, 1000]"});
  expectRefusal("solver: {substeps: -1}", {"solver.substeps"});
  expectRefusal("solver: {relaxation: 1.5}", {"solver.relaxation"});
  expectRefusal("solver: {epsilon: -1}", {"solver.epsilon"});
  expectRefusal("solver: {frame_rate_hz: -60}", {"solver.frame_rate_hz"});
  expectRefusal("gravity_m_s2: [0, 0, 1e9]", {"gravity_m_s2.2"});
  expectRefusal("temperature: {initial_c: -300}", {"temperature.initial_c"});
  expectRefusal("blocks: [{min_m: [0, 0, -1e5]}]", {"blocks.0.min_m.2"});
  for (const char* bad : {".nan", ".inf", "-.inf", "1e400", "1e5000"}) {
    expectRefusal(std::string("fluid: {spacing_m: ") + bad + "}", {"fluid.spacing_m"});
    expectRefusal(std::string("gravity_m_s2: [0, 0, ") + bad + "]", {"gravity_m_s2"});
  }
}

TEST(SceneRefusalTest, WrongTypesSayWhatIsWanted) {
  expectRefusal("fluid: {spacing_m: thick}", {"fluid.spacing_m = thick", "number"});
  expectRefusal("fluid: {spacing_m: [1]}", {"fluid.spacing_m", "number"});
  expectRefusal("solver: {substeps: 2.5}", {"solver.substeps = 2.5", "whole number"});
  expectRefusal("gravity_m_s2: -9.81", {"gravity_m_s2", "three numbers"});
  expectRefusal("gravity_m_s2: [0, -9.81]", {"gravity_m_s2", "three numbers"});
  const std::string gradient = "blocks: [{velocity_gradient_1_s: ";
  expectRefusal(gradient + "3}]", {"blocks.0.velocity_gradient_1_s = 3", "three rows"});
  expectRefusal(gradient + "[1, 2, 3]}]", {"velocity_gradient_1_s.0 = 1", "three numbers"});
  expectRefusal(gradient + "[[1, 0, 0], [0, 1], [0, 0, 0]]}]", {"gradient_1_s.1", "three numbers"});
  expectRefusal(gradient + "[[0, 0, .nan], [0, 1, 0], [0, 0, 0]]}]", {"gradient_1_s.0.2"});
  expectRefusal("blocks: [{shape: cone}]", {"blocks.0.shape = cone", "box, sphere, cylinder"});
  expectRefusal("fluid: {self_density: maybe}", {"fluid.self_density", "true or false"});
  expectRefusal("fluid: {kernel: gauss}", {"fluid.kernel", "cubic, poly6_spiky"});
  expectRefusal("preset: fast", {"preset", "default, paper"});
  expectRefusal("preset: paper\nthermal: {enabled: true}", {"preset = paper", "preset to default"});
  expectRefusal("fluid: 3", {"fluid must be a map"});
  expectRefusal("blocks: {min_m: [0, 0, 0]}", {"blocks must be a list"});
  expectRefusal("blocks: [3]", {"blocks.0 must be a map"});
  expectRefusal("name: [a]", {"name must be a text"});
}

TEST(SceneRefusalTest, KeysOfOlderSceneFilesSayTheirPresentName) {
  expectRefusal("heat: {enabled: true}", {"unknown key heat; did you mean thermal?"});
  expectRefusal("thermal: {fusion_j_kg: 1}",
                {"thermal.fusion_j_kg; did you mean thermal.latent_heat_fusion_j_kg?"});
  expectRefusal("fluid: {wall_density: true}", {"did you mean fluid.boundary_density?"});
  expectRefusal("blocks: [{spin_rad_s: [0, 0, 1]}]",
                {"did you mean blocks.0.angular_velocity_rad_s?"});
  expectRefusal("solver: {heat: 1}", {"unknown key solver.heat", "allowed: frame_rate_hz"});
}

TEST(SceneRefusalTest, FilesThatAreNoScene) {
  expectRefusal("[1, 2]", {"a scene is a map"});
  expectRefusal("just text", {"a scene is a map"});
  expectRefusal("a: [1, 2", {"origin"});
  expectRefusal("a: b: c", {"not valid YAML"});
  expectRefusal("fluid: *nothing", {"not valid YAML"});
  expectRefusal(std::string("name: \0x", 8) + "\x01\x02", {"origin"});
}

TEST(SceneRefusalTest, MoreEntriesThanAllowed) {
  std::string yaml = "spheres:\n";
  for (int k = 0; k < 1001; ++k) yaml += "  - {}\n";
  expectRefusal(yaml, {"spheres has 1001 entries"});
}

TEST(SceneRefusalTest, TwoCollidersOfOneName) {
  expectRefusal("spheres: [{name: ball}]\ncontainers: [{name: ball}]",
                {"two colliders are called ball"});
  expectRefusal("planes: [{name: sphere_0}]\nspheres: [{}]", {"sphere_0"});
}

TEST(SceneTest, UnnamedCollidersAreNumbered) {
  const Scene scene = parseScene("spheres: [{}, {}]\nplanes: [{}]\ncontainers: [{}]");
  EXPECT_EQ(scene.spheres[1].name, "sphere_1");
  EXPECT_EQ(scene.planes[0].name, "plane_0");
  EXPECT_EQ(scene.containers[0].name, "container_0");
}

TEST(SceneTest, CopiesOfABlockAreBlocks) {
  const Scene scene = parseScene(
      "blocks: [{min_m: [0, 0, 0], max_m: [0.1, 0.1, 0.1], copies: [2, 1, 3], "
      "copies_step_m: [0.5, 9, 0.25]}, {min_m: [1, 1, 1], max_m: [2, 2, 2]}]");
  ASSERT_EQ(scene.blocks.size(), 7u);
  EXPECT_EQ(scene.blocks[1].min_m, Vec3d(0, 0, 0.25));
  EXPECT_EQ(scene.blocks[5].max_m, Vec3d(0.6, 0.1, 0.6));
  EXPECT_EQ(scene.blocks[6].min_m, Vec3d(1, 1, 1));
  EXPECT_EQ(scene.blocks[5].copies, Vec3d(1, 1, 1));
}

TEST(SceneRefusalTest, CopiesThatAreNotWholeOrTooMany) {
  const std::string block = "{min_m: [0, 0, 0], max_m: [1, 1, 1], copies: ";
  expectRefusal("blocks: [" + block + "[1.5, 1, 1]}]", {"blocks.0.copies = [1.5, 1, 1]", "whole"});
  expectRefusal("blocks: [" + block + "[1000, 2, 1]}]", {"at most 1000"});
  expectRefusal("blocks: [" + block + "[0, 1, 1]}]", {"blocks.0.copies.0", "[1, 1000]"});
  std::string many = "blocks:\n";
  for (int k = 0; k < 11; ++k) many += "  - " + block + "[1000, 1, 1]}\n";
  expectRefusal(many, {"more than 10000", "blocks.10.copies"});
}

TEST(SceneTest, EmptyTextIsTheDefaultScene) {
  EXPECT_EQ(parseScene("").solver.substeps, Scene().solver.substeps);
  EXPECT_EQ(parseScene("# nothing").fluid.spacing_m, Scene().fluid.spacing_m);
}

TEST(OverrideTest, AnOverrideBeatsTheFileWhichBeatsThePresetWhichBeatsTheDefault) {
  const int preset = 4, file = 3, over = 2;
  EXPECT_EQ(parseScene("").solver.iterations, SolverParams().iterations);
  EXPECT_EQ(parseScene("preset: paper").solver.iterations, preset);
  EXPECT_EQ(parseScene("preset: paper\nsolver: {iterations: 3}").solver.iterations, file);
  EXPECT_EQ(parseScene("solver: {iterations: 3}\npreset: paper").solver.iterations, file);
  EXPECT_EQ(parseScene("solver: {iterations: 3}", {{"preset", "paper"}}).solver.iterations, file);
  EXPECT_EQ(parseScene("preset: paper", {{"preset", "default"}}).solver.iterations,
            SolverParams().iterations);
  EXPECT_EQ(parseScene("preset: paper\nsolver: {iterations: 3}", {{"solver.iterations", "2"}})
                .solver.iterations,
            over);
  const Scene scaled = parseScene("preset: paper", {{"fluid.spacing_m", "0.0422"}});
  EXPECT_DOUBLE_EQ(scaled.supportRadius_m(), 0.06);
  EXPECT_DOUBLE_EQ(scaled.fluid.particle_mass_kg, 8.0);
}

TEST(OverrideTest, ReachesIntoLists) {
  const std::string yaml = "spheres: [{radius_m: 1, position_m: [0, 0, 0]}, {radius_m: 2}]";
  const Scene scene = parseScene(yaml, {{"spheres.1.radius_m", "3"},
                                        {"spheres.0.position_m.2", "5"},
                                        {"gravity_m_s2", "[1, 2, 3]"}});
  EXPECT_EQ(scene.spheres[0].radius_m, 1);
  EXPECT_EQ(scene.spheres[0].position_m.z(), 5);
  EXPECT_EQ(scene.spheres[1].radius_m, 3);
  EXPECT_EQ(scene.gravity_m_s2, Vec3d(1, 2, 3));
}

TEST(OverrideTest, ReachesIntoRowsOfAVelocityGradient) {
  const std::string yaml =
      "blocks: [{shape: sphere, max_m: [1, 1, 1], angular_velocity_rad_s: [0, 0, 3],"
      " velocity_gradient_1_s: [[1, 2, 3], [4, 5, 6], [7, 8, 9]]}]";
  const Scene scene = parseScene(yaml, {{"blocks.0.velocity_gradient_1_s.1.2", "-6"}});
  Mat3<double> expected;
  expected << 1, 2, 3, 4, 5, -6, 7, 8, 9;
  EXPECT_EQ(scene.blocks[0].velocity_gradient_1_s, expected);
  EXPECT_EQ(scene.blocks[0].shape, BlockShape::kSphere);
  EXPECT_EQ(scene.blocks[0].angular_velocity_rad_s.z(), 3);
}

TEST(OverrideTest, RefusesWhatIsNotThere) {
  const std::string yaml = "spheres: [{radius_m: 1}]";
  expectRefusal(yaml, {"spheres.3", "1 entries"}, {{"spheres.3.radius_m", "3"}});
  expectRefusal(yaml, {"spheres.x"}, {{"spheres.x.radius_m", "3"}});
  expectRefusal(yaml, {"spheres.-1"}, {{"spheres.-1.radius_m", "3"}});
  expectRefusal(yaml, {"no planes"}, {{"planes.0.friction", "1"}});
  expectRefusal(yaml, {"duration_s.x"}, {{"duration_s", "1"}, {"duration_s.x", "1"}});
  expectRefusal(yaml, {"iterationss"}, {{"solver.iterationss", "3"}});
  expectRefusal(yaml, {"solver.iterations"}, {{"solver.iterations", "[1"}});
  expectRefusal(yaml, {"solver.iterations"}, {{"solver.iterations", ""}});
  for (const char* key : {".", "solver.iterations.", "solver..iterations", ".solver"}) {
    expectRefusal(yaml, {key, "is not a key"}, {{key, "3"}});
  }
}

TEST(MessageTest, EchoesNoMoreThanAHundredCharacters) {
  try {
    loadScene(std::string(100000, 'x'));
    FAIL() << "no such scene";
  } catch (const InvalidInput& e) {
    std::string names;
    for (const std::string& name : sceneNames()) names += name + ", ";
    EXPECT_LT(std::string(e.what()).size(), names.size() + 250U);
    EXPECT_NE(std::string(e.what()).find("dam_break"), std::string::npos) << e.what();
  }
  EXPECT_EQ(shortened(std::string("paper\0x", 7)), "paper");
  EXPECT_EQ(numberText(-0.0), "0");
}

TEST(OverrideTest, TextIsKeyEqualsValue) {
  const Override change = parseOverride("a.b=c=d");
  EXPECT_EQ(change.key, "a.b");
  EXPECT_EQ(change.value, "c=d");
  for (const char* bad : {"", "=", "=3", "solver.iterations"}) {
    EXPECT_THROW(parseOverride(bad), InvalidInput) << bad;
  }
}

TEST(SceneFileTest, UnknownNamesGetASuggestion) {
  try {
    loadScene("dam_brake");
    FAIL() << "accepted";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean dam_break?"), std::string::npos) << e.what();
  }
  for (const char* bad :
       {"", "nothing.yaml", "/", "/tmp", "../dam_break", "/dev/zero", "a/b.yaml"}) {
    EXPECT_THROW(loadScene(bad), InvalidInput) << bad;
  }
}

TEST(SceneFileTest, ScenesWithKnownAnswersComeAfterTheOrdinaryOnesAndLoadByName) {
  const fs::path known = fs::path(sceneFolder()) / "verification";
  const std::vector<std::string> names = sceneNames();
  const auto first = std::find(names.begin(), names.end(), "free_fall");
  ASSERT_NE(first, names.end());
  EXPECT_LT(std::find(names.begin(), names.end(), "two_containers"), first);
  EXPECT_FALSE(fs::exists(known / (names.front() + ".yaml")));
  EXPECT_TRUE(fs::exists(known / (names.back() + ".yaml")));
  EXPECT_EQ(loadScene("free_fall").name, "free_fall");
}

TEST(DefaultYamlTest, TheCommittedFileIsWhatTheCodeWrites) {
  std::ifstream file(std::string(IIB_CONFIG) + "/default.yaml");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), defaultYaml())
      << "write it anew: run_scene --defaults > config/default.yaml";
}

TEST(DefaultYamlTest, ParsesToTheDefaults) {
  const std::string yaml = defaultYaml();
  const Scene read = parseScene(yaml);
  EXPECT_EQ(read.name, Scene().name);
  EXPECT_EQ(read.gravity_m_s2, Scene().gravity_m_s2);
  EXPECT_EQ(read.fluid.spacing_m, FluidParams().spacing_m);
  EXPECT_EQ(read.solver.viscosity_1_s, SolverParams().viscosity_1_s);
  EXPECT_EQ(read.springs.keep_frozen, SpringParams().keep_frozen);
  EXPECT_EQ(read.limits.max_particles, LimitParams().max_particles);
}

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, RunsUnderBothPresetsOrWithHeatOrSolidsUnderItsOwn) {
  const fs::path path = GetParam();
  for (const char* preset : {"default", "paper"}) {
    const Scene own = loadScene(path.string());
    // The density of the paper's water is 45000, far from that of any solid.
    if (std::string(preset) == "paper" && (own.thermal.enabled || !own.solids.empty())) {
      EXPECT_THROW(loadScene(path.string(), {{"preset", preset}}), InvalidInput);
      continue;
    }
    const Scene scene = loadScene(path.string(), {{"preset", preset}});
    EXPECT_EQ(scene.name, path.stem().string());
    EXPECT_FALSE(scene.description.empty());
    const auto simulation = makeSimulation(scene);
    for (int k = 0; k < 3; ++k) simulation->advanceFrame();
    EXPECT_GT(simulation->report().particles, 0u);
    EXPECT_EQ(simulation->report().non_finite, 0u);
    EXPECT_EQ(countEscaped(*simulation), 0u);
    std::vector<ParticleSample> samples;
    simulation->sample(samples, 1);
    for (const ParticleSample& s : samples) {
      ASSERT_TRUE(std::isfinite(s.x + s.y + s.z + s.vx + s.vy + s.vz + s.density));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Config, ShippedScene, testing::ValuesIn([] {
                           std::vector<std::string> paths;
                           for (const auto& entry : fs::recursive_directory_iterator(
                                    std::string(IIB_CONFIG) + "/scenes")) {
                             if (entry.path().extension() == ".yaml")
                               paths.push_back(entry.path().string());
                           }
                           std::sort(paths.begin(), paths.end());
                           return paths;
                         }()),
                         [](const auto& shipped) {
                           const fs::path path = shipped.param;
                           return path.parent_path().stem().string() + "_" + path.stem().string();
                         });

}  // namespace scene_loader_test
}  // namespace ice_ice_baby
