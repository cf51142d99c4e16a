// Bodies of ice at extreme speeds, in moving containers and crowded: all stay inside and finite.
#include <gtest/gtest.h>

#include "ice/ice_rig.h"

namespace ice_ice_baby {
namespace ice_extremes_test {

using test::brick;
using test::IceRig;
using test::iceScene;
using test::Random;

constexpr double kSpacing_m = 0.05;
constexpr double kRadius_m = kSpacing_m / 2;

template <class Real>
class IceExtremesTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(IceExtremesTest, Reals);

Scene closedTank() {
  Scene scene = iceScene(0.3);
  scene.solver.max_speed_m_s = 1e5;
  scene.containers.push_back(test::tankOf({1.0, 0.8, 0.6}, false));
  return scene;
}

/// Depth of a point in the walls of the closed tank at that pose.
double depthInTank(const Posed& pose, const Vec3d& x) {
  const Vec3d local = pose.toLocal(x);
  const Vec3d beyond = local.cwiseAbs() - Vec3d(0.5, 0.4, 1e9) + Vec3d::Constant(kRadius_m);
  return std::max({beyond.x(), beyond.y(), kRadius_m - local.z(), local.z() - 0.6 + kRadius_m});
}

TYPED_TEST(IceExtremesTest, NothingLeavesAClosedContainerAtAnySpeed) {
  Random random(3);
  for (int k = 0; k < 60; ++k) {
    Scene scene = closedTank();
    Sphere ball;
    ball.name = "ball";
    ball.position_m = {0.3, 0.2, 0};
    ball.radius_m = 0.15;
    scene.spheres.push_back(ball);
    IceRig<TypeParam> rig(scene, {brick({4, 3, 2}, kSpacing_m, {-0.2, -0.1, 0.3}, {10, 20, 30}),
                                  brick({1, 1, 1}, kSpacing_m, {-0.2, 0.2, 0.3})});
    for (const Index g : {0u, 1u}) {
      rig.launch(g, random.direction() * std::pow(10.0, random.uniform(0, 3)),
                 random.direction() * std::pow(10.0, random.uniform(-1, 3)));
    }
    for (int step = 0; step < 60; ++step) {
      rig.substep(1.0 / 360);
      for (const Vec3d& x : rig.byId()) {
        ASSERT_TRUE(x.allFinite());
        ASSERT_LT(depthInTank(Posed(), x), kRadius_m);
        ASSERT_LT(0.15 - (x - ball.position_m).norm(), 0.0);
      }
    }
  }
}

TYPED_TEST(IceExtremesTest, FastBodiesDoNotPassPlatesNorTheGround) {
  for (const double speed : {1.0, 30.0, 1000.0}) {
    Scene scene = iceScene(0.3);
    scene.solver.max_speed_m_s = 1e5;
    Plane ground, plate;
    ground.name = "ground";
    plate.name = "plate";
    plate.position_m = {0, 0, 1};
    plate.size_x_m = plate.size_y_m = 3;
    plate.thickness_m = 0.01;
    scene.planes = {ground, plate};
    IceRig<TypeParam> rig(scene, {brick({3, 3, 3}, kSpacing_m, {0.1, 0, 1.2}, {5, 9, 3}),
                                  brick({3, 3, 3}, kSpacing_m, {2.5, 0, 0.5}, {5, 9, 3})});
    for (const Index g : {0u, 1u}) rig.launch(g, {0, 0, -speed});
    for (int k = 0; k < 30; ++k) rig.substep(1.0 / 360);
    EXPECT_GT(rig.body(0).pose.centre_m.z(), 1.0);
    EXPECT_GT(rig.lowest(), 0.0);
  }
}

TYPED_TEST(IceExtremesTest, TheSpeedLimitHoldsForTheFastestMember) {
  Scene scene = closedTank();
  scene.solver.max_speed_m_s = 20;
  IceRig<TypeParam> rig(scene, {brick({4, 3, 2}, kSpacing_m, {0, 0, 0.3})});
  rig.launch(0, {700, 0, 0}, {0, 100, 0});
  rig.substep(1.0 / 360);
  EXPECT_GT(rig.bodies.limited(), 0u);
  EXPECT_LE(rig.fastest(), 20.001);
}

TYPED_TEST(IceExtremesTest, ABodyWhoseMomentaAreNotFiniteRestsWhereItIs) {
  IceRig<TypeParam> rig(closedTank(), {brick({3, 3, 3}, kSpacing_m, {0, 0, 0.3})});
  const Vec3d centre = rig.body(0).pose.centre_m;
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    for (const bool spins : {false, true}) {
      IceBody& body = rig.body(0);
      (spins ? body.angular_momentum : body.velocity_m_s).y() = bad;
      rig.substep(1.0 / 360);
      EXPECT_TRUE(body.velocity_m_s.allFinite() && body.angular_momentum.allFinite());
      EXPECT_LT((rig.body(0).pose.centre_m - centre).norm(), 1e-3);
      EXPECT_LT(rig.fastest(), 0.2);
    }
  }
  EXPECT_GE(rig.bodies.limited(), 4u);
}

TYPED_TEST(IceExtremesTest, AMovingContainerCarriesAnAnchoredBodyAndPushesALooseOne) {
  IceRig<TypeParam> rig(closedTank(), {brick({3, 3, 3}, kSpacing_m, {0.42, 0, 0.4}),
                                       brick({3, 3, 3}, kSpacing_m, {-0.3, 0, 0.075})});
  for (Index i = 0; i < rig.particles.size(); ++i) {
    const Index b = rig.bodies.bodyOf(i);
    if (rig.group_of_id[rig.particles.id[i]] == 0) rig.bodies.anchor(b, 0, rig.colliders);
  }
  const Posed start = rig.colliders.pose("tank");
  const Vec3d held = rig.body(0).pose.centre_m;
  Posed pose = start;
  for (int frame = 0; frame < 60; ++frame) {
    pose = poseOf({0.03 * frame, 0.2 * std::sin(0.2 * frame), 0.1}, {0, 2.0 * frame, 3.0 * frame});
    rig.colliders.moveTo("tank", pose);
    for (int k = 0; k < 6; ++k) {
      rig.colliders.setSubstep(k / 6.0, (k + 1) / 6.0);
      rig.substep(1.0 / 360);
    }
    rig.colliders.endFrame();
    rig.colliders.setSubstep(1, 1);
    for (const Vec3d& x : rig.byId()) ASSERT_LT(depthInTank(pose, x), kRadius_m);
  }
  EXPECT_LT((rig.body(0).pose.centre_m - pose.toWorld(start.toLocal(held))).norm(), 1e-5);
  EXPECT_GT(rig.body(1).pose.centre_m.x(), 0.5);
}

TYPED_TEST(IceExtremesTest, AContainerThatJumpsTakesItsIceAlong) {
  IceRig<TypeParam> rig(closedTank(), {brick({3, 3, 3}, kSpacing_m, {0.1, 0, 0.1})});
  rig.run(1.0);
  ASSERT_EQ(rig.bodies.asleep(), 1u);
  const Posed pose = poseOf({30, -20, 10}, {40, 50, 60});
  rig.colliders.moveTo("tank", pose);
  rig.colliders.setSubstep(0, 1);
  rig.substep(1.0 / 60);
  rig.colliders.endFrame();
  rig.colliders.setSubstep(1, 1);
  for (int k = 0; k < 60; ++k) {
    for (const Vec3d& x : rig.byId()) ASSERT_LT(depthInTank(pose, x), kRadius_m);
    rig.substep(1.0 / 360);
  }
}

TYPED_TEST(IceExtremesTest, ManyBodiesInATooSmallTankStayInside) {
  Scene scene = closedTank();
  std::vector<std::vector<Vec3d>> groups;
  for (int k = 0; k < 60; ++k) {
    const Vec3d centre(-0.35 + 0.17 * (k % 5), -0.25 + 0.16 * (k / 5 % 4), 0.12 + 0.18 * (k / 20));
    groups.push_back(brick({3, 3, 3}, kSpacing_m, centre, {7.0 * k, 11.0 * k, 0}));
  }
  IceRig<TypeParam> rig(scene, groups);
  rig.run(1.0);
  for (const Vec3d& x : rig.byId()) {
    ASSERT_TRUE(x.allFinite());
    ASSERT_LT(depthInTank(Posed(), x), kRadius_m);
  }
  EXPECT_LT(rig.fastest(), 3.0);
}

TYPED_TEST(IceExtremesTest, CoincidentMembersPartTheSameWayInEveryRun) {
  Scene scene = iceScene();
  scene.gravity_m_s2.setZero();
  const auto separated = [&] {
    IceRig<TypeParam> rig(scene, {{Vec3d::Zero()}, {Vec3d::Zero()}});
    rig.run(2.0);
    return Vec3d(rig.body(0).pose.centre_m - rig.body(1).pose.centre_m);
  };
  const Vec3d apart = separated();
  EXPECT_GT(apart.norm(), kSpacing_m);
  EXPECT_EQ(separated(), apart);
}

}  // namespace ice_extremes_test
}  // namespace ice_ice_baby
