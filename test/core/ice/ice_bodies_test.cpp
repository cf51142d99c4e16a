#include "ice/ice_bodies.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <numeric>

#include "ice/ice_rig.h"

namespace ice_ice_baby {
namespace ice_bodies_test {

using test::brick;
using test::IceRig;
using test::iceScene;
using test::Random;

constexpr double kSpacing_m = 0.05;

template <class Real>
class IceBodiesTest : public testing::Test {
 protected:
  /// Rounding of coordinates of the size of the scene.
  static constexpr double kHair = sizeof(Real) == 8 ? 1e-14 : 2e-7;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(IceBodiesTest, Reals);

Scene weightless() {
  Scene scene = iceScene();
  scene.gravity_m_s2.setZero();
  return scene;
}

TEST(RotationByTest, IsTheExponentialMapAtEveryAngle) {
  for (const double angle : {0.0, 1e-12, 1e-7, 1e-6, 1e-3, 1.0, 3.0, 40.0}) {
    const Vec3d axis = Vec3d(1, -2, 0.5).normalized();
    const Mat3<double> expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((quaternionBy(angle * axis).toRotationMatrix() - expected).norm(), 1e-14) << angle;
  }
}

TYPED_TEST(IceBodiesTest, FreeRotationKeepsAngularMomentumAndEnergy) {
  // Ten turns in ten seconds; the second, about the axis of middle inertia, tumbles.
  for (const Vec3d& spin : {Vec3d(0, 0, 6.28), Vec3d(0.05, 6.28, 0.02), Vec3d(3, 4, 2)}) {
    IceRig<TypeParam> rig(weightless(), {brick({6, 4, 2}, kSpacing_m, Vec3d::Zero())});
    rig.launch(0, Vec3d::Zero(), spin);
    const Vec3d before = rig.body(0).angular_momentum;
    const double energy = rig.energy();
    for (int k = 0; k < 3600; ++k) {
      rig.substep(1.0 / 360);
      ASSERT_NEAR(rig.energy(), energy, 1e-4 * energy);
    }
    EXPECT_LE((rig.body(0).angular_momentum - before).norm(), 1e-12 * before.norm());
    EXPECT_GT((rig.body(0).pose.rotation_matrix - Mat3<double>::Identity()).norm(), 1e-3);
    EXPECT_EQ(rig.bodies.limited(), 0u);
  }
}

/// Share of its angular momentum that a dumbbell keeps if the velocities of its ends are set to
/// (x* - x) / dt, as in the paper.
double leftByFirstOrder(double angular_velocity_rad_s, double dt_s, int substeps) {
  Vec3d x(kSpacing_m / 2, 0, 0);
  Vec3d v(0, angular_velocity_rad_s * kSpacing_m / 2, 0);
  const double before = x.cross(v).z();
  for (int k = 0; k < substeps; ++k) {
    const Vec3d end = (x + dt_s * v).normalized() * kSpacing_m / 2;
    v = (end - x) / dt_s;
    x = end;
  }
  return x.cross(v).z() / before;
}

TYPED_TEST(IceBodiesTest, ADumbbellKeepsTheSpinThatFirstOrderVelocitiesLose) {
  const double dt = 1.0 / 600, spin = 2 * M_PI;
  const double law = 1 / std::sqrt(1 + 2 * spin * spin * dt * 1.0);
  EXPECT_NEAR(leftByFirstOrder(spin, dt, 600), law, 1e-3);
  EXPECT_LT(law, 0.95);

  IceRig<TypeParam> rig(weightless(), {brick({2, 1, 1}, kSpacing_m, Vec3d::Zero())});
  rig.launch(0, Vec3d::Zero(), {0, 0, spin});
  for (int k = 0; k < 600; ++k) rig.substep(dt);
  EXPECT_NEAR(double(rig.particles.velocity.at(0).norm()), spin * kSpacing_m / 2, 1e-6);
  EXPECT_NEAR(rig.at(0).x(), -kSpacing_m / 2, 1e-4);  // one turn, with a second-order error
}

TYPED_TEST(IceBodiesTest, FreeFallIsSymplecticEuler) {
  IceRig<TypeParam> rig(iceScene(), {brick({3, 3, 3}, kSpacing_m, {0, 0, 1})});
  rig.launch(0, {0.4, 0, 0});
  const double dt = 1.0 / 360;
  for (int k = 0; k < 100; ++k) rig.substep(dt);
  const double t = 100 * dt;
  const Vec3d ideal(0.4 * t, 0, 1 - 9.81 / 2 * t * (t + dt));
  EXPECT_LT((rig.body(0).pose.centre_m - ideal).norm(), 1e-12 + TestFixture::kHair);
}

TYPED_TEST(IceBodiesTest, DistancesBetweenMembersStay) {
  IceRig<TypeParam> rig(iceScene(), {brick({4, 3, 3}, kSpacing_m, {0, 0, 1})});
  const std::vector<Vec3d> before = rig.byId();
  rig.launch(0, {1, 2, 3}, {4, -6, 5});
  for (int k = 0; k < 500; ++k) rig.substep(1.0 / 360);
  const std::vector<Vec3d> after = rig.byId();
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double was = (before[i] - before[j]).norm(), is = (after[i] - after[j]).norm();
      EXPECT_NEAR(is, was, 20 * TestFixture::kHair);
    }
  }
}

TYPED_TEST(IceBodiesTest, JoiningAndSplittingKeepMomentaAndMoveNothing) {
  IceRig<TypeParam> rig(weightless(), {brick({4, 3, 3}, kSpacing_m, {-0.1, 0, 0}),
                                       brick({4, 3, 3}, kSpacing_m, {0.1, 0.02, 0.01})});
  rig.launch(0, {1, 2, 3}, {4, -6, 5});
  rig.launch(1, {-1, 0.5, 3}, {0, 2, 1});
  const auto sameAfter = [&](const std::vector<Index>& groups) {
    const Vec3d linear = rig.momentum(), angular = rig.angularMomentum();
    const std::vector<Vec3d> before = rig.byId();
    rig.group_of_id = groups;
    EXPECT_TRUE(rig.assign());
    EXPECT_LT((rig.momentum() - linear).norm(), 1e-12 * linear.norm());
    EXPECT_LT((rig.angularMomentum() - angular).norm(), 1e-12 * angular.norm());
    rig.bodies.predict(rig.particles, rig.colliders, Vec3d::Zero(), 0.0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_LT((before[i] - rig.byId()[i]).norm(), 2 * TestFixture::kHair);
    }
    rig.substep(1.0 / 360);
  };
  sameAfter(std::vector<Index>(72, 0));
  std::vector<Index> thirds(72);
  for (Index id = 0; id < 72; ++id) thirds[id] = id % 3;
  sameAfter(thirds);
  std::vector<Index> singles(72);
  std::iota(singles.begin(), singles.end(), Index(0));
  sameAfter(singles);
  sameAfter(std::vector<Index>(72, 0));
}

TYPED_TEST(IceBodiesTest, MeltingLosesNoMoreThanTheSpinOfParticles) {
  IceRig<TypeParam> rig(weightless(), {brick({6, 6, 6}, kSpacing_m, Vec3d::Zero())});
  rig.launch(0, {1, 2, 3}, {4, -6, 5});
  rig.substep(1.0 / 360);
  const Vec3d before = rig.angularMomentum();
  rig.group_of_id.assign(216, kNone);
  EXPECT_TRUE(rig.assign());
  EXPECT_EQ(rig.bodies.count(), 0u);
  Vec3d after = Vec3d::Zero();
  const double mass = 1000 * std::pow(kSpacing_m, 3);
  for (std::size_t i = 0; i < 216; ++i) {
    after += mass * rig.particles.position.at(i).template cast<double>().cross(
                        rig.particles.velocity.at(i).template cast<double>());
  }
  EXPECT_LT((after - before).norm(), 0.04 * before.norm());
}

TYPED_TEST(IceBodiesTest, ABodyThatStaysKeepsEverything) {
  IceRig<TypeParam> rig(weightless(), {brick({3, 3, 3}, kSpacing_m, {-1, 0, 0}),
                                       brick({3, 3, 3}, kSpacing_m, {1, 0, 0})});
  rig.launch(1, {1, 2, 3}, {4, -6, 5});
  rig.substep(1.0 / 360);
  EXPECT_FALSE(rig.assign());
  const IceBody before = rig.body(1);
  for (Index id = 0; id < 27; ++id) rig.group_of_id[id] = id < 5 ? kNone : 0;
  EXPECT_TRUE(rig.assign());
  const IceBody& after = rig.body(1);
  EXPECT_EQ(after.pose.centre_m, before.pose.centre_m);
  EXPECT_EQ(after.pose.rotation_matrix, before.pose.rotation_matrix);
  EXPECT_EQ(after.angular_momentum, before.angular_momentum);
  EXPECT_EQ(rig.body(0).count(), 22u);
}

TYPED_TEST(IceBodiesTest, SingleParticlesAndRowsAreBodiesToo) {
  IceRig<TypeParam> rig(weightless(), {brick({1, 1, 1}, kSpacing_m, Vec3d::Zero()),
                                       brick({5, 1, 1}, kSpacing_m, {1, 0, 0})});
  for (const Index g : {0u, 1u}) {
    rig.launch(g, {0.1, 0, 0}, {7, 0, 0});
    EXPECT_NEAR((rig.body(g).angularVelocity() - Vec3d(7, 0, 0)).norm(), 0, 1e-12);
  }
  for (int k = 0; k < 100; ++k) rig.substep(1.0 / 360);
  for (const Vec3d& x : rig.byId()) EXPECT_TRUE(x.allFinite());
}

TYPED_TEST(IceBodiesTest, ConformTakesDisplacementsAsImpulses) {
  IceRig<TypeParam> rig(weightless(), {brick({5, 4, 3}, kSpacing_m, {0.1, 0.2, 0.3})});
  const double dt = 1.0 / 360;
  rig.bodies.predict(rig.particles, rig.colliders, Vec3d::Zero(), dt);
  const Vec3d centre = rig.body(0).next.centre_m;
  const double mass = rig.body(0).mass_kg / 60;
  Random random(7);
  Vec3d linear = Vec3d::Zero(), angular = Vec3d::Zero();
  for (std::size_t i = 0; i < 60; ++i) {
    const Vec3<TypeParam> before = rig.particles.predicted.at(i);
    rig.particles.predicted.add(i, (1e-3 * random.direction()).template cast<TypeParam>());
    const Vec3d by = (rig.particles.predicted.at(i) - before).template cast<double>();
    linear += mass / dt * by;
    angular += mass / dt * (before.template cast<double>() - centre).cross(by);
  }
  rig.bodies.conform(rig.particles.predicted);
  EXPECT_LT((rig.momentum() - linear).norm(), 1e-10 * linear.norm());
  EXPECT_LT((rig.body(0).angular_momentum - angular).norm(), 1e-5 * angular.norm());
  const Vec3d moved = rig.body(0).next.centre_m - centre;
  EXPECT_LT((moved - dt * rig.body(0).velocity_m_s).norm(), 1e-15);
  const IceBody before = rig.body(0);
  rig.bodies.conform(rig.particles.predicted);
  EXPECT_EQ(rig.body(0).velocity_m_s, before.velocity_m_s);
}

TYPED_TEST(IceBodiesTest, TakesTheMomentaOfChangedVelocities) {
  IceRig<TypeParam> rig(weightless(), {brick({5, 4, 3}, kSpacing_m, Vec3d::Zero())});
  const Vec3d spin(1, 2, 3);
  for (std::size_t i = 0; i < 60; ++i) {
    const Vec3d x = rig.particles.position.at(i).template cast<double>();
    const Vec3d v = Vec3d(4, 5, 6) + spin.cross(x);
    rig.particles.velocity.set(i, v.template cast<TypeParam>());
  }
  rig.bodies.takeVelocities(rig.particles);
  EXPECT_LT((rig.body(0).velocity_m_s - Vec3d(4, 5, 6)).norm(), 20 * TestFixture::kHair);
  // Less than all, as single particles do not spin but the body's inertia includes their own.
  const double share = rig.body(0).angularVelocity().norm() / spin.norm();
  EXPECT_GT(share, 0.85);
  EXPECT_LT(share, 1.0);
}

TYPED_TEST(IceBodiesTest, AbsurdSpinsStayFiniteAndAreCounted) {
  IceRig<TypeParam> rig(weightless(), {brick({4, 2, 2}, kSpacing_m, Vec3d::Zero())});
  rig.launch(0, Vec3d::Zero(), {1e6, 2e6, 3e6});
  for (int k = 0; k < 100; ++k) rig.substep(1.0 / 360);
  for (const Vec3d& x : rig.byId()) EXPECT_LT(x.norm(), 1.0);
  EXPECT_LE(rig.fastest(), rig.scene.solver.max_speed_m_s * 1.001);
  EXPECT_GT(rig.bodies.limited(), 0u);
}

TYPED_TEST(IceBodiesTest, SameBitsForAnyNumberOfThreadsAndAnyOrderOfPlaces) {
  const auto runOn = [](int threads, bool shuffle) {
    Scene scene = iceScene();
    Plane ground;
    ground.name = "ground";
    scene.planes.push_back(ground);
    std::vector<std::vector<Vec3d>> groups{brick({14, 14, 14}, kSpacing_m, {0, 0, 0.6})};
    for (int k = 0; k < 40; ++k) {
      groups.push_back(brick({2, 2, 2}, kSpacing_m, {0.11 * (k % 7), 0.7 + 0.11 * (k / 7), 0.3},
                             {double(k), 20, 30}));
    }
    IceRig<TypeParam> rig(scene, groups);
    rig.launch(0, {0, 1, 0}, {1, 2, 3});
    tbb::task_arena(threads).execute([&] {
      for (int k = 0; k < 120; ++k) {
        if (shuffle && k == 30) {
          std::vector<Index> order(rig.particles.size());
          std::iota(order.rbegin(), order.rend(), Index(0));
          rig.particles.reorder(order);
          rig.bodies.reorder(order);
          rig.sort();
        }
        rig.substep(1.0 / 360);
      }
    });
    return rig.byId();
  };
  const std::vector<Vec3d> one = runOn(1, false);
  EXPECT_EQ(one, runOn(2, false));
  EXPECT_EQ(one, runOn(2, true));
}

}  // namespace ice_bodies_test
}  // namespace ice_ice_baby
