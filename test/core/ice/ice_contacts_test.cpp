#include "ice/ice_contacts.h"

#include <gtest/gtest.h>

#include "ice/ice_rig.h"

namespace ice_ice_baby {
namespace ice_contacts_test {

using test::brick;
using test::IceRig;
using test::iceScene;

constexpr double kSpacing_m = 0.05;

template <class Real>
class IceContactsTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(IceContactsTest, Reals);

Scene onGround(double friction, double tilt_deg = 0) {
  Scene scene = iceScene(friction);
  Plane ground;
  ground.name = "ground";
  ground.friction = friction;
  ground.rpy_deg = {0, tilt_deg, 0};
  scene.planes.push_back(ground);
  return scene;
}

TYPED_TEST(IceContactsTest, ABlockLandsWhenABodyInFreeFallWould) {
  IceRig<TypeParam> rig(onGround(0.05), {brick({4, 4, 4}, kSpacing_m, {0, 0, 1.1})});
  const double height_m = rig.lowest() - kSpacing_m / 2;
  const double dt = 1.0 / 360;
  while (rig.lowest() - kSpacing_m / 2 > 1e-4 && rig.time_s < 2) rig.substep(dt);
  EXPECT_NEAR(rig.time_s, std::sqrt(2 * height_m / 9.81), dt);
  rig.run(0.5);
  EXPECT_LT(rig.fastest(), 1e-4) << "no restitution";
}

TYPED_TEST(IceContactsTest, RestsWithoutTiltDriftOrJitter) {
  for (const int n : {1, 2, 5, 12}) {
    Scene scene = onGround(0.3);
    scene.ice.sleep_speed_m_s = 0;
    IceRig<TypeParam> rig(scene,
                          {brick(Vec3d(n, n, std::min(n, 3)), kSpacing_m, {0.1, 0.2, 0.15})});
    rig.run(1.0);
    const std::vector<Vec3d> before = rig.byId();
    double fastest = 0.0;
    for (int second = 0; second < (n == 12 ? 3 : 20); ++second) {
      rig.run(1.0);
      fastest = std::max(fastest, rig.fastest());
    }
    EXPECT_LT(fastest, 1e-4) << n;
    EXPECT_GT(rig.lowest(), (0.5 - 0.01) * kSpacing_m);
    const std::vector<Vec3d> after = rig.byId();
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_LT((after[i] - before[i]).norm(), 0.01 * kSpacing_m);
    }
    EXPECT_EQ(rig.contacts.limited(), 0u);
  }
}

TYPED_TEST(IceContactsTest, WhatRestsSleepsAtRestAndWakesWhereItWas) {
  IceRig<TypeParam> rig(onGround(0.3), {brick({5, 5, 3}, kSpacing_m, {0, 0, 0.1})});
  rig.run(0.45);
  EXPECT_EQ(rig.bodies.asleep(), 0u);
  rig.run(1.0);
  EXPECT_EQ(rig.bodies.asleep(), 1u);
  EXPECT_EQ(rig.fastest(), 0.0);
  EXPECT_EQ(rig.contacts.count(), 0u);
  const std::vector<Vec3d> before = rig.byId();
  rig.bodies.wakeAll();
  EXPECT_EQ(rig.bodies.asleep(), 0u);
  rig.run(0.2);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT((rig.byId()[i] - before[i]).norm(), 1e-4 * kSpacing_m);
  }
}

TYPED_TEST(IceContactsTest, NeverSleepsUnsupportedNorWet) {
  Scene floating = iceScene();
  floating.gravity_m_s2.setZero();
  IceRig<TypeParam> free(floating, {brick({3, 3, 3}, kSpacing_m, Vec3d::Zero())});
  free.run(2.0);
  EXPECT_EQ(free.bodies.asleep(), 0u);

  IceRig<TypeParam> rig(onGround(0.3), {brick({3, 3, 3}, kSpacing_m, {0, 0, 0.075})});
  rig.run(1.0);
  ASSERT_EQ(rig.bodies.asleep(), 1u);
  std::vector<std::uint8_t> wet(27, 0);
  rig.bodies.updateSleep(wet, 0.01);
  EXPECT_EQ(rig.bodies.asleep(), 1u);
  wet[rig.bodies.placeOf(0)] = 1;
  rig.bodies.updateSleep(wet, 0.01);
  EXPECT_EQ(rig.bodies.asleep(), 0u);
}

TYPED_TEST(IceContactsTest, FrictionHoldsBelowItsAngleAndSlidesAboveIt) {
  struct Case {
    double friction, tilt_deg;
  };
  for (const Case& c :
       {Case{0.2, 8}, Case{0.5, 25}, Case{0.2, 14}, Case{0.2, 25}, Case{0.5, 30}, Case{0, 10}}) {
    Scene scene = onGround(c.friction, c.tilt_deg);
    scene.ice.sleep_speed_m_s = 0;
    const Posed slope = poseOf(Vec3d::Zero(), {0, c.tilt_deg, 0});
    const Vec3d start = slope.toWorld({0, 0, 1.5 * kSpacing_m});
    IceRig<TypeParam> rig(scene, {brick({6, 6, 3}, kSpacing_m, start, {0, c.tilt_deg, 0})});
    rig.run(1.0);
    const double angle = c.tilt_deg * M_PI / 180;
    const double ideal = 9.81 * (std::sin(angle) - c.friction * std::cos(angle));
    const double speed = rig.body(0).velocity_m_s.norm();
    if (ideal < 0) {
      EXPECT_LT(speed, 1e-5);
      EXPECT_LT((rig.body(0).pose.centre_m - start).norm(), 0.01 * kSpacing_m);
    } else {
      EXPECT_NEAR(speed, ideal, 0.02 * ideal);
    }
  }
}

TYPED_TEST(IceContactsTest, ASingleParticleOfIceSlidesOrStaysAndDoesNotRoll) {
  for (const double friction : {0.1, 0.5}) {
    Scene scene = onGround(friction, 10);
    scene.ice.sleep_speed_m_s = 0;
    const Posed slope = poseOf(Vec3d::Zero(), {0, 10, 0});
    const Vec3d start = slope.toWorld({0, 0, kSpacing_m / 2});
    IceRig<TypeParam> rig(scene, {brick({1, 1, 1}, kSpacing_m, start, {0, 10, 0})});
    rig.run(1.0);
    const double angle = 10 * M_PI / 180;
    const double ideal = 9.81 * std::max(0.0, std::sin(angle) - friction * std::cos(angle));
    EXPECT_NEAR(rig.body(0).velocity_m_s.norm(), ideal, 0.01);
    EXPECT_LT(rig.body(0).angularVelocity().norm(), 1e-3);
  }
}

TYPED_TEST(IceContactsTest, ATumblingCubeComesToRestFlat) {
  IceRig<TypeParam> rig(onGround(0.3), {brick({5, 5, 5}, kSpacing_m, {0, 0, 0.6}, {30, 40, 10})});
  rig.launch(0, {0.5, 0.2, 0}, {3, 5, 1});
  rig.run(4.0);
  EXPECT_EQ(rig.bodies.asleep(), 1u);
  EXPECT_NEAR(rig.body(0).pose.centre_m.z(), 2.5 * kSpacing_m, 1e-3 * kSpacing_m);
  EXPECT_NEAR(rig.lowest(), kSpacing_m / 2, 1e-3 * kSpacing_m);
}

TYPED_TEST(IceContactsTest, AStackRestsAndWakesTogether) {
  Scene scene = onGround(0.3);
  const double gap_m = kSpacing_m / std::cbrt(scene.ice.density_ratio);
  std::vector<std::vector<Vec3d>> slabs;
  for (int k = 0; k < 3; ++k) {
    const double z = 1.5 * kSpacing_m + k * (2 * kSpacing_m + gap_m);
    slabs.push_back(brick({5, 5, 3}, kSpacing_m, {0, 0, z}));
  }
  IceRig<TypeParam> rig(scene, slabs);
  rig.run(3.0);
  EXPECT_EQ(rig.bodies.asleep(), 3u);
  for (Index k = 0; k < 3; ++k) {
    const double z = 1.5 * kSpacing_m + k * (2 * kSpacing_m + gap_m);
    EXPECT_NEAR(rig.body(k).pose.centre_m.z(), z, 0.01 * kSpacing_m);
  }
  // Without the lowest slab the others are not supported.
  for (Index id = 0; id < 75; ++id) rig.group_of_id[id] = 3;
  for (Index id = 0; id < 25; ++id) rig.group_of_id[id] = 4;
  rig.assign();
  rig.run(0.05);
  EXPECT_FALSE(rig.body(1).asleep);
}

TYPED_TEST(IceContactsTest, TwoStackedBricksFallAsleepTogether) {
  // If the upper brick slept first, its weight would no longer press on the lower one.
  Scene scene = onGround(0.3);
  const double gap_m = kSpacing_m / std::cbrt(scene.ice.density_ratio);
  IceRig<TypeParam> rig(scene, {brick({4, 4, 2}, kSpacing_m, {0, 0, kSpacing_m}),
                                brick({4, 4, 2}, kSpacing_m, {0.05, 0, 2 * kSpacing_m + gap_m})});
  std::size_t asleep = 0;
  for (int k = 0; k < 720; ++k) {
    rig.substep(1.0 / 360);
    asleep = rig.bodies.asleep();
    ASSERT_NE(asleep, 1u);
  }
  EXPECT_EQ(asleep, 2u);
}

TYPED_TEST(IceContactsTest, FacesLieOnEachOtherWhereverTheirLatticesAre) {
  for (const double shift : {0.0, 0.25, 0.5}) {
    Scene scene = onGround(0.3);
    const double gap_m = kSpacing_m / std::cbrt(scene.ice.density_ratio);
    const Vec3d above(shift * kSpacing_m, shift * kSpacing_m, 2 * kSpacing_m + gap_m);
    IceRig<TypeParam> rig(scene, {brick({6, 6, 2}, kSpacing_m, {0, 0, kSpacing_m}),
                                  brick({4, 4, 2}, kSpacing_m, above)});
    rig.run(1.5);
    EXPECT_NEAR(rig.body(1).pose.centre_m.z(), 2 * kSpacing_m + gap_m, 1e-3 * kSpacing_m) << shift;
    EXPECT_LT(rig.fastest(), 1e-4);
  }
}

TYPED_TEST(IceContactsTest, IceSlidesOnIceByItsFrictionNotByItsParticles) {
  Scene scene = iceScene(0.1);
  Plane ground;
  ground.name = "ground";
  ground.friction = 10;
  ground.rpy_deg = {0, 12, 0};
  scene.planes.push_back(ground);
  scene.ice.sleep_speed_m_s = 0;
  const double gap_m = kSpacing_m / std::cbrt(scene.ice.density_ratio);
  const Posed slope = poseOf(Vec3d::Zero(), {0, 12, 0});
  const auto on = [&](const Vec3d& size, double x, double z) {
    return brick(size, kSpacing_m, slope.toWorld({x, 0, z}), {0, 12, 0});
  };
  IceRig<TypeParam> rig(
      scene, {on({24, 8, 2}, 0.2, kSpacing_m), on({4, 4, 2}, -0.1, 2 * kSpacing_m + gap_m)});
  rig.run(0.75);
  const double angle = 12 * M_PI / 180;
  const double ideal = 0.75 * 9.81 * (std::sin(angle) - 0.1 * std::cos(angle));
  EXPECT_NEAR(rig.body(1).velocity_m_s.norm(), ideal, 0.03 * ideal);
  EXPECT_LT(rig.body(0).velocity_m_s.norm(), 1e-3);
}

TYPED_TEST(IceContactsTest, WhatHitsASleeperWakesIt) {
  Scene scene = onGround(0.3);
  IceRig<TypeParam> rig(scene, {brick({3, 3, 3}, kSpacing_m, {0, 0, 0.075}),
                                brick({3, 3, 3}, kSpacing_m, {0, 0, 6.0})});
  rig.run(1.0);
  ASSERT_EQ(rig.bodies.asleep(), 1u);
  const double lowest_m = rig.lowest();
  rig.run(0.2);
  EXPECT_EQ(rig.bodies.asleep(), 0u);
  EXPECT_GT(rig.lowest(), lowest_m - 0.1 * kSpacing_m);
}

TYPED_TEST(IceContactsTest, CollisionsKeepMomentaAndMakeNoEnergy) {
  Scene scene = iceScene(0.3);
  scene.gravity_m_s2.setZero();
  IceRig<TypeParam> rig(scene, {brick({4, 4, 4}, kSpacing_m, {-0.3, 0.02, 0}),
                                brick({3, 5, 4}, kSpacing_m, {0.3, 0, 0.03})});
  rig.launch(0, {2, 0, 0}, {1, 2, 3});
  rig.launch(1, {-3, 0, 0.1});
  const Vec3d linear = rig.momentum(), angular = rig.angularMomentum();
  double energy = rig.energy();
  for (int k = 0; k < 360; ++k) {
    rig.substep(1.0 / 360);
    EXPECT_LT(rig.energy(), energy * (1 + 1e-3));
    energy = std::min(energy, rig.energy());
  }
  EXPECT_LT((rig.momentum() - linear).norm(), 1e-12 * linear.norm());
  EXPECT_LT((rig.angularMomentum() - angular).norm(), 1e-12 * angular.norm());
  EXPECT_LT(rig.body(0).velocity_m_s.x(), rig.body(1).velocity_m_s.x()) << "they did not meet";
}

TYPED_TEST(IceContactsTest, OverlappingBodiesPartSlowly) {
  Scene scene = iceScene();
  scene.gravity_m_s2.setZero();
  IceRig<TypeParam> rig(scene, {brick({3, 3, 3}, kSpacing_m, {-0.07, 0, 0}),
                                brick({3, 3, 3}, kSpacing_m, {0.07, 0, 0})});
  rig.run(1.0);
  EXPECT_LT(rig.fastest(), 0.1);
  EXPECT_GT(rig.body(1).pose.centre_m.x() - rig.body(0).pose.centre_m.x(), 0.151);
}

}  // namespace ice_contacts_test
}  // namespace ice_ice_baby
