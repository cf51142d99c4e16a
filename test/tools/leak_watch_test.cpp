// What counts as a leak.
#include "leaks/leak_watch.h"

#include <gtest/gtest.h>

#include "leaks/motions.h"

namespace ice_ice_baby::leaks {
namespace {

constexpr double kSpacing_m = 0.006, kFrame_s = 0.01;

std::vector<ParticleSample> at(const Vec3d& place) {
  ParticleSample sample{};
  sample.x = float(place.x());
  sample.y = float(place.y());
  sample.z = float(place.z());
  return {sample};
}

/// Counts of a particle that goes from one place to another in a frame, in the frame of the vessel.
LeakCounts countsOf(const std::string& vessel, const Vec3d& from, const Vec3d& to,
                    bool placed = false) {
  LeakWatch watch(makeVessel(vessel, kSpacing_m, true), kSpacing_m);
  const Posed pose{Vec3d(0.3, -0.2, 0.1),
                   Eigen::AngleAxisd(1.2, Vec3d(1, 2, 3).normalized()).toRotationMatrix()};
  watch.start(at(from), {});
  watch.frame(at(pose.toWorld(to)), pose, kFrame_s, placed);
  return watch.take();
}

TEST(LeakWatchTest, APathThroughTheWallOfEachVesselIsALeak) {
  for (const std::string& vessel : vesselNames()) {
    const Vec3d within(0, 0, 0.03), without(0.07, 0.001, 0.03), below(0, 0.001, -0.02);
    for (const Vec3d& outside : {without, below}) {
      EXPECT_EQ(countsOf(vessel, within, outside).through_wall, 1u) << vessel;
    }
    EXPECT_EQ(countsOf(vessel, within, Vec3d(0.01, 0.01, 0.04)).through_wall, 0u) << vessel;
  }
}

TEST(LeakWatchTest, WaterThatEntersThroughAWallLeaksToo) {
  EXPECT_EQ(countsOf("shell", {0.07, 0, 0.03}, {0, 0.001, 0.03}).through_wall, 1u);
}

TEST(LeakWatchTest, WaterOutsideHasNoPathWhenTheVesselIsPlacedElsewhere) {
  EXPECT_EQ(countsOf("cup", {0.07, 0, 0.03}, {0, 0.001, 0.03}, true).through_wall, 0u);
  EXPECT_EQ(countsOf("cup", {0, 0.001, 0.03}, {0.07, 0, 0.03}, true).through_wall, 1u);
}

TEST(LeakWatchTest, OverTheRimIsNoLeak) {
  const LeakCounts counts = countsOf("cup", {0.04, 0, 0.098}, {0.06, 0, 0.098});
  EXPECT_EQ(counts.through_wall, 0u);
  EXPECT_EQ(counts.escaped_over_rim, 1u);
  EXPECT_DOUBLE_EQ(counts.particle_seconds, 0.0);
}

TEST(LeakWatchTest, CountsTheTimeOfParticlesAtTheVessel) {
  EXPECT_DOUBLE_EQ(countsOf("cup", {0, 0, 0.03}, {0, 0, 0.031}).particle_seconds, kFrame_s);
}

TEST(LeakWatchTest, CountsPlacesThatAreNotFinite) {
  EXPECT_EQ(countsOf("cup", {0, 0, 0.03}, Vec3d::Constant(std::nan(""))).not_finite, 1u);
}

TEST(LeakWatchTest, TheMeshOfManyTrianglesHasThem) {
  EXPECT_NEAR(double(makeVessel("dense_cup", kSpacing_m, false).walls.triangles.size()), 1e5, 1e3);
}

TEST(VesselMotionTest, ReachesItsSpeedAndNoMore) {
  for (const std::string& name : motionNames()) {
    const auto motion = makeMotion(name, 3);
    const double step_s = 1e-3;
    Posed last = motion->at(0.0);
    double speed = 0.0, rate = 0.0;
    for (int k = 1; k < 3000; ++k) {
      const Posed pose = motion->at(k * step_s);
      ASSERT_TRUE(pose.rotation.isUnitary(1e-9)) << name;
      speed = std::max(speed, (pose.position - last.position).norm() / step_s);
      rate = std::max(
          rate, Eigen::AngleAxisd(last.rotation.transpose() * pose.rotation).angle() / step_s);
      last = pose;
    }
    if (name == "shaken") {
      EXPECT_NEAR(speed, 9.5, 0.6);
    }
    if (name == "tumbled") {
      EXPECT_NEAR(rate, 19, 1.01);
    }
    if (name == "spun") {
      EXPECT_NEAR(rate, 60, 0.1);
    }
    if (name == "teleported") {
      EXPECT_NEAR(speed, 1000, 5);
    }
  }
}

}  // namespace
}  // namespace ice_ice_baby::leaks
