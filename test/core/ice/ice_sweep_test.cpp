// Bodies of ice fast enough to pass through each other within a substep.
#include <gtest/gtest.h>

#include "ice/ice_rig.h"

namespace ice_ice_baby {
namespace ice_sweep_test {

using test::brick;
using test::IceRig;
using test::iceScene;
using test::Random;

constexpr double kSpacing_m = 0.05;

Scene freeSpace() {
  Scene scene = iceScene(0.3);
  scene.gravity_m_s2.setZero();
  scene.solver.max_speed_m_s = 1e5;
  return scene;
}

template <class Real>
class IceSweepTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(IceSweepTest, Reals);

TYPED_TEST(IceSweepTest, BodiesMeetHeadOnAtAnySpeedAndDoNotPass) {
  for (const Vec3d& size : {Vec3d(1, 1, 1), Vec3d(1, 4, 4), Vec3d(3, 3, 3)}) {
    for (const double speed : {1.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
      const double aside =
          size.y() > 1 ? 0.003 : 0.0;  // single particles would roll past each other
      IceRig<TypeParam> rig(freeSpace(), {brick(size, kSpacing_m, {-0.7, aside, 0}),
                                          brick(size, kSpacing_m, {0.7, 0, 0})});
      rig.launch(0, {speed, 0, 0});
      rig.launch(1, {-speed, 0, 0});
      const double before = rig.energy();
      for (int k = 0; k < int(400 / speed) + 20; ++k) {
        rig.substep(1.0 / 360);
        const double apart = rig.body(1).pose.centre_m.x() - rig.body(0).pose.centre_m.x();
        ASSERT_GT(apart, 0.0) << speed;
        ASSERT_LT(rig.momentum().norm(), 1e-9 * rig.body(0).mass_kg * speed);
        ASSERT_LE(rig.energy(), before * (1 + 1e-9));
        if (rig.energy() < 0.9 * before) break;  // from here on they slide and roll
      }
      EXPECT_LT(rig.energy(), 0.9 * before) << "they met, without restitution";
    }
  }
}

TYPED_TEST(IceSweepTest, CollisionsOffTheCentreKeepBothMomentaAndMakeNoEnergy) {
  Random random(12345);
  int met = 0, free = 0;
  for (int k = 0; k < 1000; ++k) {
    // One statement each, as the order in which arguments are evaluated is unspecified.
    const Vec3d turn_a = 180 * random.direction();
    const Vec3d turn_b = 180 * random.direction();
    const Vec3d beside{0.5, random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    IceRig<TypeParam> rig(freeSpace(), {brick({3, 2, 4}, kSpacing_m, {-0.5, 0, 0}, turn_a),
                                        brick({2, 3, 2}, kSpacing_m, beside, turn_b)});
    const double speed = std::pow(10.0, random.uniform(1.3, 3));
    rig.launch(0, {speed, 0, 0}, 5 * random.direction());
    rig.launch(1, {-speed, 0, 0}, 5 * random.direction());
    const Vec3d linear = rig.momentum(), angular = rig.angularMomentum();
    const double before = rig.energy();
    for (int step = 0; step < 40; ++step) rig.substep(1.0 / 360);
    const double scale = rig.body(0).mass_kg * speed;
    EXPECT_LT((rig.momentum() - linear).norm(), 1e-9 * scale);
    if (rig.bodies.limited() == 0) {  // else the limit of a radian a substep took spin away
      EXPECT_LT((rig.angularMomentum() - angular).norm(), 1e-3 * scale) << speed;
      ++free;
    }
    // Five of these overlap so deeply that separating them at once would add energy.
    EXPECT_LE(rig.energy(), before * 1.001) << speed;
    met += rig.energy() < 0.95 * before;
  }
  EXPECT_GT(met, 400);
  EXPECT_GT(free, 80);
}

TYPED_TEST(IceSweepTest, AFastBodyWakesASleeperInsteadOfPassingIt) {
  Scene scene = freeSpace();
  scene.gravity_m_s2 = {0, 0, -9.81};
  scene.planes.emplace_back();
  IceRig<TypeParam> rig(scene, {brick({3, 3, 3}, kSpacing_m, {0, 0, 0.075}),
                                brick({2, 2, 2}, kSpacing_m, {-2, 0, 3.075})});
  rig.body(1).asleep = true;
  for (int k = 0; k < 400 && !rig.body(0).asleep; ++k) rig.substep(1.0 / 360);
  ASSERT_TRUE(rig.body(0).asleep);
  rig.body(1).asleep = false;
  rig.body(1).pose.centre_m = rig.body(1).next.centre_m = {-2, 0, 0.08};
  rig.launch(1, {500, 0, 0});
  for (int k = 0; k < 10; ++k) {
    rig.substep(1.0 / 360);
    ASSERT_LT(rig.body(1).pose.centre_m.x(), rig.body(0).pose.centre_m.x());
  }
  EXPECT_FALSE(rig.body(0).asleep);
  EXPECT_GT(rig.body(0).velocity_m_s.x(), 10);
}

TYPED_TEST(IceSweepTest, FastBodiesInAClosedTankStayInsideAndFinite) {
  Scene scene = freeSpace();
  scene.containers.push_back(test::tankOf({2, 2, 2}, false));
  Random random(92);
  std::vector<std::vector<Vec3d>> groups;
  for (int k = 0; k < 27; ++k) {
    const Vec3d centre(0.6 * (k % 3 - 1), 0.6 * (k / 3 % 3 - 1), 0.4 + 0.6 * (k / 9));
    groups.push_back(brick({2, 2, 2}, kSpacing_m, centre, 180 * random.direction()));
  }
  IceRig<TypeParam> rig(scene, groups);
  for (Index g = 0; g < 27; ++g) rig.launch(g, 800 * random.direction(), 5 * random.direction());
  const double before = rig.energy();
  for (int k = 0; k < 60; ++k) {
    rig.substep(1.0 / 360);
    for (const Vec3d& x : rig.byId()) {
      ASSERT_TRUE(x.allFinite());
      ASSERT_LT((x - Vec3d(0, 0, 1)).template lpNorm<Eigen::Infinity>(), 1.0);
    }
  }
  EXPECT_LT(rig.energy(), before);
}

}  // namespace ice_sweep_test
}  // namespace ice_ice_baby
