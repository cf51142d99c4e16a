// Damaged checkpoints and those of other versions are refused, and the message names the file.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"

namespace ice_ice_baby {
namespace damaged_checkpoint_test {

using test::fullTank;

/// Message of decodeCheckpoint; "" if it accepts the bytes.
std::string refusal(std::string_view bytes) {
  return test::refusalOf([&] { decodeCheckpoint(bytes, "some/run.ckpt", 1); });
}

std::string smallCheckpoint() {
  const auto simulation = makeSimulation(fullTank(2), Precision::kFloat, 1);
  simulation->advanceFrame();
  return encodeCheckpoint(*simulation);
}

TEST(DamagedCheckpointTest, TruncatedAnywhereIsRefusedByName) {
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

}  // namespace damaged_checkpoint_test
}  // namespace ice_ice_baby
