// Bounds of the motion of colliders that follow tf, and stamps of frames.
#include "motion_limit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frame_stamps.h"
#include "turns.h"

namespace ice_ice_baby {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

Posed at(const Vec3d& position, const Vec3d& turn = Vec3d::Zero()) {
  return {position, rotationBy(turn)};
}

TEST(MotionLimit, MotionWithinTheBoundsIsExact) {
  MotionLimit limit;
  limit.start(at({0, 0, 0}));
  for (int k = 1; k < 200; ++k) {
    const double t = k * kFrame_s;
    const Posed wanted = at({0.3 * (1 - std::cos(4 * t)), 0, 0}, {0, 0, 3 * std::sin(t)});
    const MotionLimit::Step step = limit.step(wanted, kFrame_s);
    EXPECT_EQ(step.pose.position, wanted.position);
    EXPECT_EQ(step.pose.rotation, wanted.rotation);
    EXPECT_EQ(step.behind_m, 0.0);
    EXPECT_EQ(step.behind_rad, 0.0);
  }
}

TEST(MotionLimit, AJumpIsReachedWithinTheBoundsWithoutOvershoot) {
  for (const double distance_m : {0.03, 0.2, 1.0, 10.0, 1e5}) {
    for (const double acceleration_m_s2 : {1.0, 100.0, 1e4}) {
      MotionBounds bounds;
      bounds.acceleration_m_s2 = acceleration_m_s2;
      MotionLimit limit(bounds);
      limit.start(at({0, 0, 0}));
      double x = 0.0, speed_m_s = 0.0;
      const double enough_s = 3 + distance_m / 5 + 4 * std::sqrt(distance_m / acceleration_m_s2) +
                              5.0 / acceleration_m_s2;
      for (int k = 0; k * kFrame_s < enough_s; ++k) {
        const double next = limit.step(at({distance_m, 0, 0}), kFrame_s).pose.position.x();
        const double now_m_s = (next - x) / kFrame_s;
        ASSERT_LE(std::abs(now_m_s), 5.0 + 1e-6);
        ASSERT_LE(std::abs(now_m_s - speed_m_s), acceleration_m_s2 * kFrame_s + 1e-6);
        ASSERT_LE(next, distance_m * (1 + 1e-12) + 0.2 * acceleration_m_s2 * kFrame_s * kFrame_s);
        x = next;
        speed_m_s = now_m_s;
      }
      EXPECT_NEAR(x, distance_m, 1e-9 * distance_m) << acceleration_m_s2;
    }
  }
}

TEST(MotionLimit, AMovingPoseIsCaughtUpWith) {
  MotionLimit limit;
  limit.start(at({-1, 0, 0}));
  MotionLimit::Step step;
  for (int k = 1; k < 120; ++k) step = limit.step(at({2 * k * kFrame_s, 0, 0}), kFrame_s);
  EXPECT_EQ(step.behind_m, 0.0);
}

TEST(MotionLimit, RoundingIsNoMotion) {
  MotionLimit limit;
  limit.start(at({1, 2, 3}, {0.1, 0.2, 0.3}));
  for (int k = 0; k < 10; ++k) {
    const Posed wanted = at({1 + 1e-10 * (k % 3), 2, 3}, {0.1, 0.2, 0.3 - 1e-10 * (k % 2)});
    EXPECT_EQ(limit.step(wanted, kFrame_s).pose.position, Vec3d(1, 2, 3));
  }
  const Posed wanted = at({1 + 1e-8, 2, 3}, {0.1, 0.2, 0.3});
  EXPECT_EQ(limit.step(wanted, kFrame_s).pose.position, wanted.position);
}

TEST(MotionLimit, TurningIsBounded) {
  MotionLimit limit;
  limit.start(at({0, 0, 0}));
  const Posed wanted = at({0, 0, 0}, {0, 0, 3.1});
  const MotionLimit::Step first = limit.step(wanted, kFrame_s);
  EXPECT_NEAR(turnOf(first.pose.rotation).z(), 20 * kFrame_s, 1e-12);
  EXPECT_NEAR(first.behind_rad, 3.1 - 20 * kFrame_s, 1e-12);
  for (int k = 0; k < 8; ++k) EXPECT_GT(limit.step(wanted, kFrame_s).behind_rad, 0.0);
  EXPECT_EQ(limit.step(wanted, kFrame_s).pose.rotation, wanted.rotation);
}

TEST(FrameStamps, FramesOnTimeKeepTheirStamps) {
  FrameStamps stamps;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_NEAR(stamps.next(100.0 + k * kFrame_s), 100.0 + k * kFrame_s, 1e-9);
  }
}

TEST(FrameStamps, ALateFrameHardlyShifts) {
  FrameStamps stamps;
  for (int k = 0; k < 300; ++k) {
    const double due_s = k * kFrame_s;
    const double stamp_s = stamps.next(due_s + (k == 200 ? 0.02 : 0.0));
    ASSERT_NEAR(stamp_s, due_s, 0.1 * 0.02 + 1e-9);
  }
}

TEST(FrameStamps, SlowFramesAreRegular) {
  FrameStamps stamps;
  double before_s = 0.0;
  for (int k = 0; k < 600; ++k) {
    const double begin_s = 0.03 * k + 0.004 * (k * 7 % 5);
    const double stamp_s = stamps.next(begin_s);
    if (k > 200) {
      ASSERT_NEAR(stamp_s - before_s, 0.03, 0.0012);
    }
    ASSERT_GE(stamp_s, before_s);
    before_s = stamp_s;
  }
}

TEST(FrameStamps, APauseOrAClockThatJumpsStartsAgain) {
  FrameStamps stamps;
  for (int k = 0; k < 100; ++k) stamps.next(k * kFrame_s);
  for (const double start_s : {100.0, 20.0}) {
    for (int k = 0; k < 100; ++k) {
      ASSERT_NEAR(stamps.next(start_s + k * kFrame_s), start_s + k * kFrame_s, 1e-9);
    }
  }
}

}  // namespace
}  // namespace ice_ice_baby
