// Hostile scene files: alias bombs, pipes, links, names; each is refused in one line that says why.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/machine_memory.h"
#include "fixtures.h"
#include "ice_ice_baby/scene_loader.h"
#include "loading/memory_need.h"

namespace ice_ice_baby {
namespace hostile_scene_test {

namespace fs = std::filesystem;
using test::refusalOf;

void expectWords(const std::string& message, const std::vector<std::string>& words) {
  EXPECT_NE(message, "") << "was accepted";
  EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
  EXPECT_LT(message.size(), 1500u) << message;
  for (const std::string& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << "\"" << word << "\" not in: " << message;
  }
}

void expectRefusal(const std::string& yaml, const std::vector<std::string>& words,
                   const std::vector<Override>& overrides = {}) {
  expectWords(refusalOf([&] { parseScene(yaml, overrides, "origin"); }), words);
}

TEST(HostileYaml, ADuplicateKeyIsRefusedWithBothLines) {
  expectRefusal("name: a\nfluid: {spacing_m: 1}\nname: b\n",
                {"origin", "key name stands twice", "line 1 and in line 3", "remove one"});
  expectRefusal("fluid:\n  spacing_m: 1\n  spacing_m: 2\n", {"spacing_m", "line 2 and in line 3"});
  expectRefusal("name: x", {"fluid", "stands twice"}, {{"fluid", "{spacing_m: 1, spacing_m: 2}"}});
  EXPECT_EQ(parseScene("spheres: [{name: a}, {name: b}]").spheres.size(), 2u);
}

TEST(HostileYaml, AnAliasCountsAsAllThatItStandsFor) {
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int k = 1; k < 12; ++k) {
    const std::string before = "*a" + std::to_string(k - 1), name = "a" + std::to_string(k);
    bomb += name + ": &" + name + " [" + before;
    for (int times = 1; times < 10; ++times) bomb += ", " + before;
    bomb += "]\n";
  }
  expectRefusal(bomb, {"more than 1000000 entries", "alias"});
  expectRefusal("fluid: &a {spacing_m: *a}", {"alias in line 1", "within what it stands for"});
  const Scene scene = parseScene("spheres: [&a {radius_m: 3}, *a]");
  EXPECT_EQ(scene.spheres[1].radius_m, 3.0);
}

TEST(HostileYaml, NestingIsLimited) {
  for (const char open : {'[', '{'}) {
    expectRefusal("a: " + std::string(200000, open), {"line 1", "deeper than 20"});
  }
  std::string blocks, dashes;
  for (int k = 0; k < 1000; ++k) dashes += "- ";
  expectRefusal("blocks:\n" + dashes + "1", {"deeper than 20"});
  std::string key = "a";
  for (int k = 0; k < 100000; ++k) key += ".a";
  expectRefusal("name: x", {"a.a.a", "is not a key"}, {{key, "1"}});
}

TEST(HostileYaml, IsOneDocumentOfAtMostAMebibyte) {
  expectRefusal("name: a\n---\nname: b\n", {"more than one YAML document"});
  expectRefusal("name: x\n#" + std::string(1 << 20, ' '), {"1048585 bytes", "more than 1048576"});
  expectRefusal("name: x", {"description", "more than 1048576"},
                {{"description", std::string((1 << 20) + 1, 'x')}});
}

TEST(HostileYaml, TextsMustBeShortAndPrintable) {
  expectRefusal("description: " + std::string(1001, 'x'),
                {"description = xxx", "1001 bytes", "at most 1000"});
  expectRefusal("name: \"a\\eb\"", {"name = a\\x1bb", "control character, code 27"});
  expectRefusal("name: \"a\\nb\"", {"name = a\\x0ab", "one line"});
  EXPECT_EQ(parseScene("description: \"a\\nb\"").description, "a\nb");
  EXPECT_EQ(parseScene("name: Gefäß").name, "Gefäß");
}

TEST(HostileYaml, NamesOfCollidersMustBeTfFrames) {
  for (const char* bad : {"/tank", "tank/", "my tank", "Gefäß"}) {
    const std::string yaml = std::string("spheres: [{name: ") + bad + "}]";
    expectRefusal(yaml, {"name of a collider = \"", "tf frame", "1 to 255"});
    const std::string frame = std::string("spheres: [{name: b, follow_frame: ") + bad + "}]";
    expectRefusal(frame, {"follow_frame of collider b = \"", "tf frame"});
  }
  expectRefusal("spheres: [{name: " + std::string(256, 'x') + "}]", {"1 to 255"});
  EXPECT_EQ(parseScene("spheres: [{follow_frame: robot/arm_1-b.c}]").spheres[0].follow_frame,
            "robot/arm_1-b.c");
}

TEST(HostileScene, TooManyParticlesAreCountedNotSpawned) {
  const std::string box = "{min_m: [-100, -100, -100], max_m: [100, 100, 100]}";
  expectRefusal("fluid: {spacing_m: 1e-4}\nblocks: [" + box + "]",
                {"8000000000000000000 particles", "limits.max_particles = 2e+06", "spacing_m"});
  // The first has too many points to count one by one; the second, too many rows of one point.
  expectRefusal("fluid: {spacing_m: 1e-4}\nblocks: [{shape: sphere, " + box.substr(1) + "]",
                {"particles, more than limits.max_particles"});
  expectRefusal(
      "fluid: {spacing_m: 1e-4}\nblocks: [{shape: sphere, max_m: [1e-4, 1, 1], "
      "copies: [1000, 1, 1]}]",
      {"particles, more than limits.max_particles"});
  expectRefusal("blocks: [{max_m: [1, 1, 1]}]", {"limits.max_particles = 10"},
                {{"limits.max_particles", "10"}});
  // A ball holds fewer particles than its box, and is counted exactly where that decides.
  const std::string ball = "fluid: {spacing_m: 0.01}\nblocks: [{shape: sphere, max_m: [1, 1, 1]}]";
  EXPECT_LT(particleCount(parseScene(ball, {{"limits.max_particles", "6e5"}})), 530000);
  expectRefusal(ball, {"more than limits.max_particles = 5e+05"},
                {{"limits.max_particles", "5e5"}});
}

TEST(HostileScene, MustFitTheMemoryOfTheMachine) {
  const Scene scene = parseScene("fluid: {spacing_m: 0.01}\nblocks: [{max_m: [1, 1, 1]}]");
  EXPECT_NO_THROW(requireMemory(scene, 200e6));
  expectWords(refusalOf([&] { requireMemory(scene, 199e6); }),
              {"1e+06 particles", "at least 200 MB", "has 199 MB", "fluid.spacing_m"});
  EXPECT_GT(machineMemory_bytes(), 1e8);
}

TEST(HostileScene, SweepsOfAFrameAreLimited) {
  expectRefusal("solver: {substeps: 1000, iterations: 1000}",
                {"solver.substeps x solver.iterations = 1000000", "[0, 10000]", "lower"});
  EXPECT_EQ(parseScene("solver: {substeps: 1000, iterations: 10}").solver.iterations, 10);
}

/// Each test gets an own scene folder, which ICE_ICE_BABY_SCENES names while it runs.
class HostileFolder : public testing::Test {
 protected:
  HostileFolder()
      : folder_(fs::temp_directory_path() / ("iib_hostile_" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(scenes());
    setenv("ICE_ICE_BABY_SCENES", scenes().c_str(), 1);
  }
  ~HostileFolder() override {
    unsetenv("ICE_ICE_BABY_SCENES");
    fs::remove_all(folder_);
  }

  fs::path scenes() const { return folder_ / "scenes"; }
  fs::path write(const std::string& name, const std::string& text = "name: x\n") const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  static void expectRefused(const std::string& scene, const std::vector<std::string>& words) {
    expectWords(refusalOf([&] { loadScene(scene); }), words);
  }

  const fs::path folder_;
};

TEST_F(HostileFolder, PipesDevicesAndFoldersAreRefusedUnread) {
  const fs::path pipe = folder_ / "pipe.yaml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expectRefused(pipe, {"pipe.yaml", "device or a pipe"});
  expectRefused("/dev/zero", {"/dev/zero", "device or a pipe"});
  fs::create_symlink("/dev/zero", folder_ / "zero.yaml");
  expectRefused(folder_ / "zero.yaml", {"zero.yaml", "device or a pipe"});
  expectRefused(folder_, {"is a folder"});
  fs::create_directories(folder_ / "folder.yaml");
  expectRefused(folder_ / "folder.yaml", {"is a folder"});
  const fs::path huge = write("huge.yaml");
  for (const std::uintmax_t bytes : {(std::uintmax_t(1) << 20) + 1, std::uintmax_t(1) << 40}) {
    std::error_code no_sparse_files;
    fs::resize_file(huge, bytes, no_sparse_files);
    expectRefused(huge, {"larger than 1 MiB"});
  }
  expectRefused(folder_ / ("a\nb" + std::string(5000, 'x') + ".yaml"), {"no scene file"});
  expectRefused("nowhere.yaml", {"no scene file nowhere.yaml in the folder "});
}

TEST_F(HostileFolder, ANameNeverLeadsOutOfTheSceneFolder) {
  write("scenes/inside.yaml");
  const fs::path secret = write("secret.yaml", "name: secret\n");
  fs::create_symlink(secret, scenes() / "link.yaml");
  fs::create_symlink(scenes() / "inside.yaml", scenes() / "alias.yaml");
  EXPECT_EQ(loadScene("inside").name, "x");
  EXPECT_EQ(loadScene("alias").name, "x");
  expectRefused("link", {"scene link", "leads out of the scene folder", "copy the file"});
  for (const std::string& bad :
       {std::string("..\\secret"), std::string("inside\n"), std::string("inside\0x", 8),
        std::string("."), std::string(".."), std::string(100000, 'x')}) {
    expectRefused(bad, {"no scene \"", "path of a .yaml file"});
  }
}

TEST_F(HostileFolder, ListsOnlyWhatLoadsByName) {
  write("scenes/a.yaml");
  write("scenes/b.yaml.yaml");
  fs::create_directories(scenes() / "c.yaml");
  EXPECT_EQ(sceneNames(), std::vector<std::string>{"a"});
}

TEST(MessageTest, ShowsControlCharactersAndWholeLetters) {
  EXPECT_EQ(shortened("a\nb\x7f"), "a\\x0ab\\x7f");
  const std::string cut = shortened(std::string(99, 'x') + "ää");
  EXPECT_EQ(cut, std::string(99, 'x') + "ä...");
  EXPECT_EQ(numberText(-std::nan("")), "nan");
  const std::string many = joined(std::vector<std::string>(1000, "ten_bytes_"));
  EXPECT_LT(many.size(), 2100u);
  EXPECT_NE(many.find("ten_bytes_, ten_bytes_ and 833 more"), std::string::npos) << many;
  EXPECT_EQ(nearest(std::string(1 << 20, 'x'), {"x"}), "");
}

}  // namespace hostile_scene_test
}  // namespace ice_ice_baby
