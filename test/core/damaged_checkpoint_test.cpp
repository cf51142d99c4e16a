// What is damaged, forged or of another version is refused by name and does no harm.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulator.h"
#include "stories.h"

namespace ice_ice_baby {
namespace {

using test::fullTank;
using test::stateOf;
using test::Story;

/// What decodeCheckpoint says of the bytes; "" when it takes them.
std::string refusal(std::string_view bytes) {
  try {
    decodeCheckpoint(bytes, "some/run.ckpt", 1);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

std::string smallCheckpoint() {
  const auto simulation = makeSimulation(fullTank(2), Precision::kFloat, 1);
  simulation->advanceFrame();
  return encodeCheckpoint(*simulation);
}

TEST(DamagedCheckpointTest, OfAnyLesserLengthIsRefusedByName) {
  const std::string whole = smallCheckpoint();
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string why = refusal(std::string_view(whole).substr(0, length));
    ASSERT_EQ(why.rfind("some/run.ckpt: ", 0), 0U) << length << why;
    const bool tells = why.find(length < 8 ? "not a checkpoint" : "truncated") != why.npos;
    ASSERT_TRUE(tells) << length << why;
  }
  EXPECT_NE(refusal(whole + "x").find("too long"), std::string::npos);
}

TEST(DamagedCheckpointTest, WithAnyBitFlippedIsRefusedByName) {
  std::string bytes = smallCheckpoint();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
    ASSERT_EQ(refusal(bytes).rfind("some/run.ckpt: ", 0), 0U) << "bit " << bit;
    bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
  }
  EXPECT_EQ(refusal(bytes), "");
}

TEST(DamagedCheckpointTest, OfAnotherVersionOrNoneSaysSo) {
  std::string bytes = smallCheckpoint();
  bytes[8] = 77;
  EXPECT_NE(refusal(bytes).find("version 77"), std::string::npos) << refusal(bytes);
  EXPECT_NE(refusal("blocks: []").find("not a checkpoint"), std::string::npos);
  EXPECT_NE(refusal("").find("not a checkpoint"), std::string::npos);
}

/// A few bytes somewhere else than they were: small, or as large as an index or a double can be.
std::string forged(std::string state, test::Random& random, bool large) {
  const auto at = std::size_t(random.uniform(0, double(state.size() - 8)));
  if (large) return state.replace(at & ~std::size_t(7), 8, "\xff\xff\xff\x7f\xff\xff\xef\x7f");
  state[at] = char(random.uniform(0, 256));
  return state;
}

/// A checkpoint whose checksum is that of what it holds: bytes 28 to 31 of the header.
std::string resigned(std::string bytes) {
  const auto* first = reinterpret_cast<const Bytef*>(bytes.data());
  const auto checksum =
      std::uint32_t(crc32_z(crc32_z(0, first, 28), first + 32, bytes.size() - 32));
  std::memcpy(bytes.data() + 28, &checksum, sizeof checksum);
  return bytes;
}

TEST(ForgedTest, ScenesAreRefusedByNameOrLoad) {
  const std::string whole = smallCheckpoint();
  ASSERT_EQ(resigned(whole), whole);
  const std::size_t scene_bytes =
      whole.size() - stateOf(*decodeCheckpoint(whole, "memory", 1)).size() - 32;
  test::Random random(11);
  int refused = 0;
  constexpr int kForged = 200;
  for (int k = 0; k < kForged; ++k) {
    const std::string scene = forged(whole.substr(32, scene_bytes), random, k % 2 == 0);
    const std::string why = refusal(resigned(std::string(whole).replace(32, scene.size(), scene)));
    if (why.empty()) continue;
    ++refused;
    ASSERT_EQ(why.rfind("some/run.ckpt: ", 0), 0U) << why;
  }
  EXPECT_GT(refused, kForged / 4);
  EXPECT_LT(refused, kForged);
}

class ForgedStateTest : public testing::TestWithParam<Story> {};

/// Behind the checksum stands the reader itself, as bytes may be forged. What it takes must run.
TEST_P(ForgedStateTest, IsRefusedOrRuns) {
  test::Random random(7);
  Simulator<float> original(GetParam().scene, 1);
  original.setTemperature(-10.0, 0.0, "");
  for (int frame = 0; frame < 20; ++frame) original.advanceFrame();
  const std::string state = stateOf(original);
  int refused = 0;
  constexpr int kForged = 80;
  Simulator<float> simulator(GetParam().scene, 1);
  for (int k = 0; k < kForged; ++k) {
    const std::string bytes = forged(state, random, k % 2 == 0);
    try {
      StateReader reader(bytes);
      simulator.read(reader);
      simulator.advanceFrame();
    } catch (const InvalidInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, kForged);
}

INSTANTIATE_TEST_SUITE_P(Of, ForgedStateTest,
                         testing::Values(test::hailStory(), test::kettleStory(0.0),
                                         test::coldTankStory(), Story{"frozen", fullTank(3)}),
                         [](const auto& made) { return made.param.name; });

}  // namespace
}  // namespace ice_ice_baby
