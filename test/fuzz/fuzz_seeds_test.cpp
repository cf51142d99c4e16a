// Calls each target with its committed seeds, so that what a fuzzer found is tested in every build.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "targets.h"

namespace ice_ice_baby::fuzz {
namespace {

namespace fs = std::filesystem;

struct Named {
  std::string name;
  Target target;
};

const std::vector<Named> kTargets{
    {"scene_yaml", sceneYaml},         {"overrides", overrides}, {"commands", commands},
    {"checkpoint", checkpoint},
#ifdef IIB_FUZZ_ROS
    {"parameter_tree", parameterTree}, {"requests", requests},
#endif
};

class FuzzSeeds : public testing::TestWithParam<Named> {};

TEST_P(FuzzSeeds, KeepEveryPromise) {
  const fs::path folder = fs::path(IIB_FUZZ_SEEDS) / GetParam().name;
  ASSERT_FALSE(fs::is_empty(folder)) << folder;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    EXPECT_NO_THROW(GetParam().target(bytes.str())) << entry.path();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, FuzzSeeds, testing::ValuesIn(kTargets),
                         [](const auto& named) { return named.param.name; });

}  // namespace
}  // namespace ice_ice_baby::fuzz
