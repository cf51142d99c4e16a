// Checkpoint files: after any interruption the file is whole, the new one or the old one.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"

namespace ice_ice_baby {
namespace checkpoint_file_test {

namespace fs = std::filesystem;

class CheckpointFileTest : public testing::Test {
 protected:
  CheckpointFileTest() { fs::create_directories(folder_); }
  ~CheckpointFileTest() override { fs::remove_all(folder_); }

  static std::string contentOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename());
    }
    return names;
  }
  /// Message of writeCheckpoint; "" if it succeeds.
  static std::string refusal(const std::string& path, const std::string& bytes = "bytes") {
    return test::refusalOf([&] { writeCheckpoint(bytes, path); });
  }

  const fs::path folder_ = fs::temp_directory_path() / ("checkpoint_" + std::to_string(getpid()));
  const std::string path_ = folder_ / "run.ckpt";
};

std::string checkpointOf(int edge) {
  return encodeCheckpoint(*makeSimulation(test::fullTank(edge), Precision::kFloat, 1));
}

TEST_F(CheckpointFileTest, IsReadAsItWasSavedAndReplacesAnOlderOne) {
  const auto simulation = makeSimulation(test::splash(), Precision::kDouble, 1);
  for (int k = 0; k < 2; ++k) {
    simulation->advanceFrame();
    saveCheckpoint(*simulation, path_);
    const auto loaded = loadCheckpoint(path_, 1);
    EXPECT_EQ(loaded->stateHash(), simulation->stateHash());
    EXPECT_EQ(loaded->precision(), Precision::kDouble);
    EXPECT_EQ(loaded->report().frame, simulation->report().frame);
  }
  EXPECT_EQ(files(), std::vector<std::string>{"run.ckpt"});
}

TEST_F(CheckpointFileTest, WhatCannotBeReadIsRefusedByName) {
  std::ofstream(path_) << "water";
  for (const std::string& path : {path_, folder_.string(), path_ + ".none"}) {
    const std::string why = test::refusalOf([&] { loadCheckpoint(path, 1); });
    EXPECT_NE(why.find(path), std::string::npos) << why;
  }
}

TEST_F(CheckpointFileTest, ALinkLeadsToTheFileThatIsReplaced) {
  std::ofstream(folder_ / "far.ckpt") << "old";
  fs::create_symlink(folder_ / "far.ckpt", path_);
  writeCheckpoint("new", path_);
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(contentOf(folder_ / "far.ckpt"), "new");
}

TEST_F(CheckpointFileTest, PlacesThatAreNoFileAreRefusedByName) {
  for (const std::string& path : {folder_.string(), std::string("/dev/null"), std::string()}) {
    EXPECT_NE(refusal(path).find("\"" + path + "\""), std::string::npos) << refusal(path);
  }
  const std::string nowhere = folder_ / "no" / "run.ckpt";
  EXPECT_NE(refusal(nowhere).find(nowhere + ": No such file"), std::string::npos);
  EXPECT_TRUE(files().empty());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(CheckpointFileTest, AFullDiskLeavesTheOldFileAndNothingElse) {
  writeCheckpoint("old", path_);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string why = refusal(path_, std::string(5000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(why.find(path_ + ": File too large"), std::string::npos) << why;
  EXPECT_EQ(contentOf(path_), "old");
  EXPECT_EQ(files(), std::vector<std::string>{"run.ckpt"});
}

/// The child only writes, as the threads of the solver do not survive a fork.
TEST_F(CheckpointFileTest, AKillWhileSavingLeavesAWholeFile) {
  const std::string one = checkpointOf(10), other = checkpointOf(11);
  writeCheckpoint(one, path_);
  test::Random random(3);
  for (int round = 0; round < 50; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) {
        writeCheckpoint(other, path_);
        writeCheckpoint(one, path_);
      }
    }
    usleep(static_cast<useconds_t>(random.uniform(0, 20e3)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::string left = contentOf(path_);
    ASSERT_TRUE(left == one || left == other) << "round " << round;
  }
  EXPECT_LE(files().size(), 2U) << "at most one unfinished file";
  EXPECT_GT(loadCheckpoint(path_, 1)->report().particles, 0U);
  writeCheckpoint(one, path_);
  EXPECT_EQ(files(), std::vector<std::string>{"run.ckpt"}) << "which the next one takes";
}

/// Each process meets the lock of the other and files that the other has just replaced.
TEST_F(CheckpointFileTest, TwoProcessesThatSaveToOneFileKeepItWhole) {
  const std::string one(200000, '1'), other(300000, '2');
  const pid_t child = fork();
  if (child == 0) {
    for (int k = 0; k < 100; ++k) writeCheckpoint(one, path_);
    _exit(0);
  }
  for (int k = 0; k < 100; ++k) {
    writeCheckpoint(other, path_);
    const std::string there = contentOf(path_);
    ASSERT_TRUE(there == one || there == other) << k;
  }
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(files(), std::vector<std::string>{"run.ckpt"});
}

}  // namespace checkpoint_file_test
}  // namespace ice_ice_baby
