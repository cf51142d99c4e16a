// The folder of checkpoints is created when needed; no name leads out of it or fills the disk; the
// newest checkpoint comes first.
#include "checkpoint_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  Folder() {
    char name[] = "/tmp/checkpoint_folder_XXXXXX";
    root_ = mkdtemp(name);
  }
  ~Folder() override { fs::remove_all(root_); }

  /// @param age_s how long ago it was written
  void put(const std::string& name, int age_s) const {
    const fs::path file = root_ / (name + ".ckpt");
    std::ofstream(file) << name;
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(age_s));
  }

  static std::string content(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string refusal(const std::string& name) const {
    try {
      folder().save("bytes", name);
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "";
  }

  CheckpointFolder folder() const { return CheckpointFolder(root_.string()); }

  fs::path root_;
};

using Names = std::vector<std::string>;

TEST_F(Folder, MustBeAnAbsolutePath) {
  for (const char* path : {"", "here", "./here", "~/here"}) {
    EXPECT_THROW(CheckpointFolder{path}, InvalidInput) << path;
  }
}

/// Sets an environment variable, or unsets it for null, until the end of the test.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    const char* before = std::getenv(name);
    had_ = before != nullptr;
    if (had_) before_ = before;
    set(value);
  }
  ~Environment() { set(had_ ? before_.c_str() : nullptr); }

 private:
  void set(const char* value) const {
    if (value) {
      setenv(name_, value, 1);
    } else {
      unsetenv(name_);
    }
  }

  const char* name_;
  bool had_;
  std::string before_;
};

template <class Call>
std::string refusalOf(const Call& call) {
  try {
    call();
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

TEST_F(Folder, IsCreatedByTheFirstSaveOrAutosave) {
  const CheckpointFolder saved((root_ / "a/b/c").string());
  EXPECT_EQ(saved.problem(), "");
  EXPECT_FALSE(fs::exists(root_ / "a"));
  EXPECT_EQ(content(saved.save("bytes", "first")), "bytes");
  EXPECT_EQ(saved.names(), Names{"first"});
  const CheckpointFolder autosaved((root_ / "x/y/").string());
  EXPECT_EQ(content(autosaved.autosave("bytes")), "bytes");
}

TEST_F(Folder, AFileInTheWayIsNamedWithTheCure) {
  std::ofstream(root_ / "file") << "not a folder";
  for (const fs::path& path : {root_ / "file", root_ / "file/below/it"}) {
    const CheckpointFolder blocked(path.string());
    for (const std::string& why :
         {blocked.problem(), refusalOf([&] { blocked.create(); }),
          refusalOf([&] { blocked.save("bytes", "name"); }),
          refusalOf([&] { blocked.autosave("bytes"); }), refusalOf([&] { blocked.find("name"); }),
          refusalOf([&] { resumeFrom(blocked, 1); })}) {
      EXPECT_NE(why.find(path.string()), std::string::npos) << why;
      EXPECT_TRUE(why.find("is not a folder") != std::string::npos ||
                  why.find("Not a directory") != std::string::npos)
          << why;
      EXPECT_NE(why.find("set ~checkpoint_folder"), std::string::npos) << why;
    }
  }
}

TEST_F(Folder, ThatCannotBeCreatedIsRefusedWithTheReason) {
  const std::string why = refusalOf([] { CheckpointFolder("/proc/self/here").create(); });
  EXPECT_NE(why.find("/proc/self/here"), std::string::npos) << why;
  EXPECT_NE(why.find("set ~checkpoint_folder"), std::string::npos) << why;
}

TEST_F(Folder, ByDefaultLiesInRosHomeOrHome) {
  const Environment ros_home("ROS_HOME", nullptr);
  const Environment home("HOME", "/home/somebody");
  EXPECT_EQ(CheckpointFolder::defaultFor("/ns/sim").path(),
            "/home/somebody/.ros/ice_ice_baby/ns/sim");
  const Environment set("ROS_HOME", "/var/lib/ros");
  EXPECT_EQ(CheckpointFolder::defaultFor("/sim").path(), "/var/lib/ros/ice_ice_baby/sim");
}

TEST_F(Folder, WithoutAHomeEveryUseIsRefusedWithTheCure) {
  const Environment ros_home("ROS_HOME", nullptr);
  for (const char* value : {static_cast<const char*>(nullptr), "", "here"}) {
    const Environment home("HOME", value);
    const CheckpointFolder none = CheckpointFolder::defaultFor("/sim");
    EXPECT_EQ(none.path(), "");
    for (const std::string& why :
         {none.problem(), refusalOf([&] { none.create(); }),
          refusalOf([&] { none.save("bytes", "name"); }), refusalOf([&] { none.find("name"); }),
          refusalOf([&] { resumeFrom(none, 1); })}) {
      EXPECT_NE(why.find("neither ROS_HOME nor HOME"), std::string::npos) << why;
      EXPECT_NE(why.find("~checkpoint_folder"), std::string::npos) << why;
    }
  }
}

TEST_F(Folder, WritesAndFindsWhatWasNamed) {
  const std::string file = folder().save("bytes", "before-Freezing_2");
  EXPECT_EQ(file, (root_ / "before-Freezing_2.ckpt").string());
  EXPECT_EQ(content(file), "bytes");
  EXPECT_EQ(folder().find("before-Freezing_2"), file);
  folder().save("newer", "before-Freezing_2");
  EXPECT_EQ(content(file), "newer");
  EXPECT_EQ(folder().names(), Names{"before-Freezing_2"});
}

TEST_F(Folder, NoNameLeadsOutOfIt) {
  for (const std::string& name :
       {std::string(), std::string("."), std::string(".."), std::string("../up"),
        std::string("/etc/passwd"), std::string("a/b"), std::string("a.b"), std::string("a b"),
        std::string("a\0b", 3), std::string("\xc3\xa4"), std::string(65, 'a')}) {
    EXPECT_NE(refusal(name).find("1 to 64 letters"), std::string::npos) << name;
    EXPECT_THROW(folder().find(name), InvalidInput) << name;
  }
  EXPECT_TRUE(fs::is_empty(root_));
  EXPECT_EQ(refusal(std::string(64, 'a')), "");
}

TEST_F(Folder, ALinkIsRefused) {
  fs::create_symlink("/tmp/elsewhere", root_ / "link.ckpt");
  EXPECT_NE(refusal("link").find("is a link"), std::string::npos);
  EXPECT_FALSE(fs::exists("/tmp/elsewhere"));
}

TEST_F(Folder, NamesOfAutosavesAreReserved) {
  EXPECT_NE(refusal("autosave_1").find("does not begin with autosave"), std::string::npos);
  folder().autosave("bytes");
  EXPECT_EQ(content(folder().find("autosave_1")), "bytes");
}

TEST_F(Folder, SuggestsAnExistingName) {
  try {
    put("melted", 0);
    folder().find("meltd");
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean melted"), std::string::npos) << e.what();
  }
}

TEST_F(Folder, ManySavesCannotFillTheDisk) {
  for (int k = 0; k < 100; ++k) put("n" + std::to_string(k), k);
  EXPECT_NE(refusal("one_more").find("100 allowed"), std::string::npos);
  EXPECT_EQ(refusal("n7"), "");  // in place of one that is there
  EXPECT_NO_THROW(folder().autosave("bytes"));
}

TEST_F(Folder, NewestFirst) {
  put("old", 30);
  put("new", 10);
  put("middle", 20);
  std::ofstream(root_ / "other.txt") << "no checkpoint";
  EXPECT_EQ(folder().names(), (Names{"new", "middle", "old"}));
}

TEST_F(Folder, AutosavesTakeTurns) {
  put("autosave_1", 20);
  put("autosave_2", 10);
  EXPECT_EQ(fs::path(folder().autosave("third")).stem(), "autosave_1");
  put("autosave_1", 5);
  EXPECT_EQ(fs::path(folder().autosave("fourth")).stem(), "autosave_2");
}

TEST_F(Folder, ResumesFromNothingWhereThereIsNothing) {
  const CheckpointFolder missing((root_ / "missing").string());
  EXPECT_EQ(missing.names(), Names{});
  const Resumption resumption = resumeFrom(missing, 1);
  EXPECT_EQ(resumption.simulation, nullptr);
  EXPECT_TRUE(resumption.broken.empty());
}

TEST_F(Folder, NamesWhatIsBroken) {
  put("broken", 0);
  put("rubbish", 10);
  const Resumption resumption = resumeFrom(folder(), 1);
  EXPECT_EQ(resumption.simulation, nullptr);
  ASSERT_EQ(resumption.broken.size(), 2u);
  EXPECT_NE(resumption.broken[0].find("broken.ckpt"), std::string::npos);
  EXPECT_NE(resumption.broken[1].find("rubbish.ckpt"), std::string::npos);
}

}  // namespace
}  // namespace ice_ice_baby
