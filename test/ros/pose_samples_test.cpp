// Samples of a tf frame that are late, repeated, invalid or too many.
#include <gtest/gtest.h>

#include <limits>

#include "pose_playback.h"
#include "turns.h"

namespace ice_ice_baby {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Posed at(const Vec3d& position, const Vec3d& turn = Vec3d::Zero()) {
  return {position, rotationBy(turn)};
}

TEST(PoseSamples, DuplicatesAndLateSamplesChangeNothing) {
  const auto path = [](double t) { return at({0.5 * t, 0, 0}, {0, 3 * t, 0}); };
  PosePlayback playback;
  const auto add = [&](int k, double arrival_s) {
    return playback.add({0.01 * k, arrival_s, path(0.01 * k)});
  };
  for (int k = 0; k < 300; k += 2) {
    const double arrival_s = 0.01 * (k + 1);
    EXPECT_TRUE(add(k + 1, arrival_s));
    EXPECT_EQ(add(k, arrival_s), k > 0) << "late; older than all for the first";
    EXPECT_FALSE(add(k + 1, arrival_s)) << "again";
    const auto played = playback.play(arrival_s);
    if (k < 100) continue;
    const Posed expected = path(arrival_s - playback.delay_s());
    ASSERT_LT((played->pose.position - expected.position).norm(), 1e-9);
    ASSERT_LT(turnOf(played->pose.rotation.transpose() * expected.rotation).norm(), 1e-7);
  }
}

TEST(PoseSamples, InvalidSamplesAreRefusedAndHugeOnesAreFinite) {
  PosePlayback playback;
  const Posed pose = at({1, 2, 3});
  EXPECT_TRUE(playback.add({0.0, 0.0, pose}));
  EXPECT_FALSE(playback.add({kNaN, 0.1, pose}));
  EXPECT_FALSE(playback.add({0.1, kNaN, pose}));
  EXPECT_FALSE(playback.add({0.1, 0.1, at({kNaN, 0, 0})}));
  EXPECT_FALSE(playback.add({0.1, 0.1, {Vec3d(0, 0, 0), kNaN * Mat3<double>::Identity()}}));
  EXPECT_FALSE(playback.add({0.1, 0.1, at({0, 1.0000001e12, 0})}));
  EXPECT_EQ(playback.samples().count(), 1u);
  for (int k = 1; k < 200; ++k) {
    playback.add({0.01 * k, 0.01 * k, at({k % 7 == 0 ? 1e12 : 1.0, 2, 3})});
    const auto played = playback.play(0.01 * k);
    ASSERT_TRUE(played->pose.position.allFinite() && played->pose.rotation.allFinite());
  }
  EXPECT_LT((playback.play(20.0)->pose.position - Vec3d(1, 2, 3)).norm(), 1e-3);
}

TEST(PoseSamples, AClockThatJumpsBackDropsWhatWasBefore) {
  for (const double back_s : {0.02, 1.0, 1000.0}) {
    PoseSamples samples;
    for (int k = 0; k < 100; ++k) {
      EXPECT_TRUE(samples.add({2000 + 0.01 * k, 2000 + 0.01 * k, at({1, 0, 0})}));
    }
    const double stamp_s = 2000.99 - back_s + 0.001;
    EXPECT_TRUE(samples.add({stamp_s, stamp_s, at({2, 0, 0})}));
    EXPECT_EQ(samples.count(), 1u) << back_s;
    EXPECT_EQ(samples.newest().pose.position.x(), 2.0);
    EXPECT_EQ(samples.epoch(), 1u);
  }
}

TEST(PoseSamples, OneGapIsNoIntervalOfTheRobotAndTwoAre) {
  PoseSamples samples;
  double stamp_s = 0.0;
  const auto add = [&](double after_s) {
    stamp_s += after_s;
    samples.add({stamp_s, stamp_s, at({stamp_s, 0, 0})});
  };
  add(0.0);
  add(0.3);
  EXPECT_NEAR(samples.interval_s(), 0.3, 1e-12);
  for (int k = 0; k < 30; ++k) add(0.02);
  EXPECT_NEAR(samples.interval_s(), 0.02, 1e-12);
  add(0.2);
  EXPECT_NEAR(samples.interval_s(), 0.2, 1e-12);
}

TEST(PoseSamples, MemoryIsBounded) {
  PosePlayback playback;
  for (int k = 0; k < 100000; ++k) playback.add({1e-5 * k, 1e-5 * k, Posed()});
  EXPECT_LE(playback.samples().count(), 4096u);
}

}  // namespace
}  // namespace ice_ice_baby
