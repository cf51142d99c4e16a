// Frames paced by a clock: lost time is dropped; ROS time may be missing, stand still or jump back.
#include "pacing.h"

#include <gtest/gtest.h>

#include <thread>

namespace ice_ice_baby {
namespace {

using std::chrono::milliseconds;

TEST(RateGate, HoldsTheRateOnAverage) {
  RateGate gate(30.0);
  const WallClock::time_point start = WallClock::now();
  int passed = 0;
  for (int frame = 0; frame < 600; ++frame) {
    passed += gate.pass(start + std::chrono::microseconds(16667 * frame), false);
  }
  EXPECT_NEAR(passed, 300, 2);
}

TEST(RateGate, UrgentMessagesPassUnlessItIsOff) {
  RateGate gate(1.0), off(0.0);
  const WallClock::time_point now = WallClock::now();
  EXPECT_TRUE(gate.pass(now, false));
  EXPECT_FALSE(gate.pass(now + milliseconds(10), false));
  EXPECT_TRUE(gate.pass(now + milliseconds(10), true));
  EXPECT_FALSE(off.pass(now, true));
}

TEST(RealTimeFactor, IsThatOfTheLatestSecond) {
  RealTimeFactor factor;
  const WallClock::time_point start = WallClock::now();
  EXPECT_EQ(factor.value(), 0.0);
  double simulated_s = 0.0;
  for (int k = 0; k < 100; ++k) factor.add(start + milliseconds(10 * k), simulated_s += 0.01);
  EXPECT_NEAR(factor.value(), 1.0, 1e-9);
  for (int k = 0; k < 200; ++k) {
    factor.add(start + milliseconds(1000 + 10 * k), simulated_s += 0.005);
  }
  EXPECT_NEAR(factor.value(), 0.5, 1e-9);
  factor.clear();
  EXPECT_EQ(factor.value(), 0.0);
}

TEST(Pacer, WithoutIntervalIsAlwaysDue) {
  Pacer pacer(0.0, false);
  pacer.frameBegins();
  EXPECT_EQ(pacer.remaining(), 0.0);
}

TEST(Pacer, HoldsTheInterval) {
  Pacer pacer(0.05, false);
  EXPECT_EQ(pacer.remaining(), 0.0);
  pacer.frameBegins();
  EXPECT_GT(pacer.remaining(), 0.03);
  EXPECT_LE(pacer.remaining(), 0.05);
}

TEST(Pacer, DropsTimeThatASlowFrameLost) {
  Pacer pacer(0.01, false);
  pacer.frameBegins();
  std::this_thread::sleep_for(milliseconds(60));
  EXPECT_EQ(pacer.remaining(), 0.0);
  pacer.frameBegins();
  EXPECT_GT(pacer.remaining(), 0.0);  // one frame, not five
}

TEST(Pacer, FrameIsDueSoonerOnlyByAShorterInterval) {
  ros::Time::init();
  ros::Time::setNow(ros::Time(50.0));
  Pacer pacer(10.0, true);
  EXPECT_EQ(pacer.remaining(), 0.0);
  pacer.frameBegins();
  ros::Time::setNow(ros::Time(54.0));
  pacer.setInterval(10.0);  // as each reset does
  EXPECT_NEAR(pacer.remaining(), 6.0, 1e-6);
  pacer.setInterval(20.0);
  EXPECT_NEAR(pacer.remaining(), 6.0, 1e-6);
  pacer.setInterval(2.0);
  EXPECT_NEAR(pacer.remaining(), 2.0, 1e-6);
}

TEST(Pacer, FollowsRosTime) {
  ros::Time::init();
  Pacer pacer(0.1, true);
  ros::Time::setNow(ros::Time(0, 0));
  EXPECT_GT(pacer.remaining(), 0.0);  // no clock yet
  ros::Time::setNow(ros::Time(50.0));
  EXPECT_EQ(pacer.remaining(), 0.0);
  pacer.frameBegins();
  EXPECT_NEAR(pacer.remaining(), 0.1, 1e-6);
  std::this_thread::sleep_for(milliseconds(120));
  EXPECT_NEAR(pacer.remaining(), 0.1, 1e-6);  // the clock stands still
  ros::Time::setNow(ros::Time(50.101));
  EXPECT_EQ(pacer.remaining(), 0.0);
  pacer.frameBegins();
  ros::Time::setNow(ros::Time(3.0));  // a bag begins again
  EXPECT_NEAR(pacer.remaining(), 0.1, 1e-6);
  ros::Time::setNow(ros::Time(3.2));
  EXPECT_EQ(pacer.remaining(), 0.0);
}

}  // namespace
}  // namespace ice_ice_baby
