#include "colliders/colliders.h"

#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {
namespace colliders_test {

using test::Random;

constexpr double kRadius_m = 0.02;

template <class Real>
class CollidersTest : public testing::Test {
 protected:
  /// Rounding of coordinates of the size of the scene, with room for a rotation there and back.
  static constexpr double kHair = sizeof(Real) == 8 ? 1e-12 : 1e-5;

  using Point = Vec3<Real>;
  static Point cast(const Vec3d& v) { return v.cast<Real>(); }
};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(CollidersTest, Reals);

Container tilted(bool open_top) {
  Container box = test::tankOf({0.8, 0.5, 0.6}, open_top);
  box.position_m = {0.3, -0.4, 1.1};
  box.rpy_deg = {25, -40, 110};
  return box;
}

/// Depth of a point, in the frame of the container, in its walls; 0 if it is not in a wall.
double depthInWalls(const Container& box, const Vec3d& local) {
  const Vec3d half(box.size_m.x() / 2, box.size_m.y() / 2, 0);
  const Vec3d inner_low = -half + Vec3d::Constant(kRadius_m);
  Vec3d inner_high = Vec3d(half.x(), half.y(), box.size_m.z()) - Vec3d::Constant(kRadius_m);
  const double out = box.wall_m + kRadius_m;
  const Vec3d outer_low = -half - Vec3d::Constant(out);
  Vec3d outer_high = Vec3d(half.x(), half.y(), box.size_m.z()) + Vec3d::Constant(out);
  if (box.open_top) inner_high.z() = outer_high.z() = box.size_m.z();
  const double within_outer =
      std::min((local - outer_low).minCoeff(), (outer_high - local).minCoeff());
  const double beyond_inner =
      std::max((inner_low - local).maxCoeff(), (local - inner_high).maxCoeff());
  return std::max(0.0, std::min(within_outer, beyond_inner));
}

TYPED_TEST(CollidersTest, NothingLeavesAClosedContainer) {
  for (const Container& box : {test::tankOf({0.8, 0.5, 0.6}, false), tilted(false)}) {
    Scene scene;
    scene.containers.push_back(box);
    const Colliders<TypeParam> colliders(scene, kRadius_m);
    const Posed pose = box.pose();
    Random random(41);
    auto at = this->cast(pose.toWorld({0, 0, 0.3}));
    for (int k = 0; k < 30000; ++k) {
      const auto to = (at + this->cast(random.anyStep())).eval();
      at = colliders.respond(at, to, k % 3 == 0);
      const Vec3d local = pose.toLocal(at.template cast<double>());
      ASSERT_LE(depthInWalls(box, local), this->kHair) << local.transpose();
      ASSERT_TRUE(colliders[0].shape.holds(this->cast(local))) << local.transpose();
    }
  }
}

TYPED_TEST(CollidersTest, NothingEntersAClosedContainer) {
  const Container box = tilted(false);
  Scene scene;
  scene.containers.push_back(box);
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const Posed pose = box.pose();
  Random random(42);
  for (int walk = 0; walk < 300; ++walk) {
    auto at = this->cast(pose.position + 1.5 * random.direction());
    for (int k = 0; k < 100; ++k) {
      const Vec3d aim = pose.toWorld(random.inBox({-0.5, -0.35, -0.1}, {0.5, 0.35, 0.7}));
      const double share = random.uniform(0.0, 3.0);
      at = colliders.respond(at, (at + TypeParam(share) * (this->cast(aim) - at)).eval(),
                             k % 2 == 0);
      const Vec3d local = pose.toLocal(at.template cast<double>());
      ASSERT_LE(depthInWalls(box, local), this->kHair) << local.transpose();
      ASSERT_FALSE(colliders[0].shape.holds(this->cast(local))) << local.transpose();
    }
  }
}

TYPED_TEST(CollidersTest, AnOpenContainerIsLeftAndEnteredThroughItsTopOnly) {
  const Container box = tilted(true);
  Scene scene;
  scene.containers.push_back(box);
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const Posed pose = box.pose();
  Random random(43);
  auto at = this->cast(pose.toWorld({0, 0, 0.3}));
  int left = 0, entered = 0;
  for (int k = 0; k < 40000; ++k) {
    const Vec3d before = pose.toLocal(at.template cast<double>());
    const Vec3d aim = pose.toWorld(random.inBox({-0.6, -0.5, -0.3}, {0.6, 0.5, 1.1}));
    const auto to = (at + TypeParam(random.uniform(0.0, 1.5)) * (this->cast(aim) - at)).eval();
    at = colliders.respond(at, to, false);
    const Vec3d after = pose.toLocal(at.template cast<double>());
    ASSERT_LE(depthInWalls(box, after), this->kHair) << after.transpose();
    const auto& shape = colliders[0].shape;
    const bool was_in = shape.holds(this->cast(before)), is_in = shape.holds(this->cast(after));
    if (was_in == is_in) continue;
    const Vec3d outer = was_in ? after : before;
    ASSERT_GE(outer.z(), box.size_m.z() - this->kHair) << "not by the mouth";
    ++(was_in ? left : entered);
  }
  EXPECT_GT(left, 100);
  EXPECT_GT(entered, 100);
}

TYPED_TEST(CollidersTest, ParticlesInAnEdgeOrCornerStayThere) {
  Scene scene;
  scene.containers.push_back(test::tankOf(Vec3d::Ones(), false));
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const Vec3d corner(0.48, -0.48, 0.02);
  for (const Vec3d& push : {Vec3d(1, -1, -1), Vec3d(1, 0, -1), Vec3d(1e-9, -1e-9, -1e-9)}) {
    const auto end = colliders.respond(this->cast(corner), this->cast(corner + push), false);
    EXPECT_LT((end.template cast<double>() - corner).norm(), this->kHair);
  }
}

TYPED_TEST(CollidersTest, AMovingContainerCarriesWhatIsInside) {
  for (const bool open_top : {false, true}) {
    const Container box = tilted(open_top);
    Scene scene;
    scene.containers.push_back(box);
    Colliders<TypeParam> colliders(scene, kRadius_m);
    Random random(44);
    Posed pose = box.pose();
    auto at = this->cast(pose.toWorld({0.1, 0.05, 0.1}));
    for (int frame = 0; frame < 200; ++frame) {
      Posed next = pose;
      next.position += 2.0 * random.inBox(-Vec3d::Ones(), Vec3d::Ones());
      next.rotation = Eigen::AngleAxisd(random.uniform(-3, 3), random.direction()) * next.rotation;
      colliders.moveTo("tank", next);
      for (int k = 0; k < 4; ++k) {
        colliders.setSubstep(k / 4.0, (k + 1) / 4.0);
        at = colliders.respond(at, at, false);
      }
      colliders.endFrame();
      pose = next;
      const Vec3d local = pose.toLocal(at.template cast<double>());
      ASSERT_LE(depthInWalls(box, local), 10 * this->kHair) << local.transpose();
      if (!open_top) {
        ASSERT_TRUE(colliders[0].shape.holds(this->cast(local)));
      }
    }
  }
}

TYPED_TEST(CollidersTest, NothingTunnelsThroughAPlateAt1000MetresPerSecond) {
  Scene scene;
  Plane plate;
  plate.name = "plate";
  plate.size_x_m = plate.size_y_m = 1.0;
  plate.thickness_m = 1e-3;
  plate.position_m = {5, 6, 7};
  plate.rpy_deg = {15, 60, -20};
  scene.planes.push_back(plate);
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const Posed pose = plate.pose();
  Random random(45);
  for (int k = 0; k < 5000; ++k) {
    const double side = k % 2 ? 1 : -1;
    const Vec3d from(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                     side * random.uniform(0.05, 3));
    const Vec3d through(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0);
    const Vec3d to = from + (through - from).normalized() * (1000.0 / 60);
    const auto end =
        colliders.respond(this->cast(pose.toWorld(from)), this->cast(pose.toWorld(to)), false);
    const double z = pose.toLocal(end.template cast<double>()).z();
    ASSERT_GE(side > 0 ? z - kRadius_m : -z - 1e-3 - kRadius_m, -this->kHair);
  }
}

TYPED_TEST(CollidersTest, NothingTunnelsThroughASphereAt1000MetresPerSecond) {
  Scene scene;
  Sphere ball;
  ball.radius_m = 0.3;
  ball.position_m = {-1, 2, 1};
  scene.spheres.push_back(ball);
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const double reach = 0.3 + kRadius_m;
  Random random(46);
  for (int k = 0; k < 5000; ++k) {
    const Vec3d from = random.uniform(0.33, 4) * random.direction();
    const Vec3d aim = 0.9 * reach * random.direction();
    const Vec3d way = (aim - from).normalized();
    const double b = from.dot(way);
    const double gap = -b - std::sqrt(b * b - from.squaredNorm() + reach * reach);
    if (!(gap > 0)) continue;
    const Vec3d normal = (from + gap * way).normalized();
    const auto end = colliders.respond(this->cast(ball.position_m + from),
                                       this->cast(ball.position_m + from + 17 * way), false);
    const Vec3d local = end.template cast<double>() - ball.position_m;
    ASSERT_GE(local.dot(normal), reach - 3e2 * this->kHair) << "through the ball";
  }
}

TYPED_TEST(CollidersTest, RandomPathsEndOutsideASphere) {
  Scene scene;
  scene.spheres.emplace_back();
  scene.spheres[0].radius_m = 0.3;
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  Random random(47);
  for (int k = 0; k < 20000; ++k) {
    const Vec3d from = random.uniform(0.0, 1.0) * random.direction();
    const Vec3d to = random.uniform(0.0, 1.0) * random.direction();
    const auto end = colliders.respond(this->cast(from), this->cast(to), k % 2 == 0);
    ASSERT_GE(double(end.norm()), 0.32 - this->kHair);
  }
}

TYPED_TEST(CollidersTest, AtTheCentreOfASphereTheWayOutIsUp) {
  Scene scene;
  scene.spheres.emplace_back();
  scene.spheres[0].radius_m = 0.3;
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const auto end = colliders.respond(this->cast({0, 0, 0}), this->cast({0, 0, 0}), false);
  EXPECT_LT((end.template cast<double>() - Vec3d(0, 0, 0.32)).norm(), this->kHair);
}

TYPED_TEST(CollidersTest, RespondingTwiceChangesNothing) {
  Scene scene;
  scene.containers.push_back(tilted(true));
  scene.planes.emplace_back();
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  Random random(48);
  for (int k = 0; k < 10000; ++k) {
    const auto from = this->cast(random.inBox({-1, -1.5, 0.02}, {1.5, 1, 3}));
    const auto to = this->cast(random.inBox({-2, -2, -1}, {2, 2, 3}));
    const auto once = colliders.respond(from, to, false);
    const auto twice = colliders.respond(once, once, false);
    // In a wedge between two colliders passes end at a ten thousandth of a radius.
    ASSERT_LT(double((twice - once).norm()), 1e-3 * kRadius_m + this->kHair);
    ASSERT_GE(double(once.z()), kRadius_m - 1e-3 * kRadius_m) << "below the ground";
  }
}

TYPED_TEST(CollidersTest, CoulombFrictionTakesItsShareOfTheDepth) {
  Scene scene;
  scene.planes.emplace_back();
  scene.planes[0].friction = 0.25;
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const auto from = this->cast({0, 0, kRadius_m});
  const auto slides = colliders.respond(from, this->cast({0.3, 0.4, kRadius_m - 0.8}), false);
  EXPECT_LT((slides.template cast<double>() - Vec3d(0.18, 0.24, kRadius_m)).norm(), this->kHair);
  const auto holds = colliders.respond(from, this->cast({0.03, 0.04, kRadius_m - 0.8}), false);
  EXPECT_LT((holds - from).norm(), this->kHair);
  const auto sticks = colliders.respond(from, this->cast({0.3, 0.4, kRadius_m - 1e-4}), true);
  EXPECT_LT((sticks - from).norm(), this->kHair);
}

TYPED_TEST(CollidersTest, APathThatTouchesNothingIsLeftAsItIs) {
  Scene scene;
  scene.containers.push_back(tilted(false));
  scene.spheres.emplace_back();
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  const auto from = this->cast({3, 3, 3}), to = this->cast({3.1, 2.9, 3.3});
  EXPECT_EQ(colliders.respond(from, to, true), to);
}

TEST(CollidersPoseTest, MovesOverTheFrameAndRefusesUnknownNames) {
  Scene scene;
  scene.containers.push_back(test::tankOf(Vec3d::Ones(), false));
  Colliders<double> colliders(scene, kRadius_m);
  Posed target;
  target.position = {1, 2, 3};
  colliders.moveTo("tank", target);
  colliders.setSubstep(0.25, 0.5);
  EXPECT_LT((colliders[0].motion.from.position - target.position / 4).norm(), 1e-15);
  EXPECT_LT((colliders[0].motion.to.position - target.position / 2).norm(), 1e-15);
  EXPECT_EQ(colliders.pose("tank").position.norm(), 0.0);
  colliders.endFrame();
  EXPECT_EQ(colliders.pose("tank").position, target.position);
  EXPECT_THROW(colliders.pose("tnak"), InvalidInput);
  EXPECT_THROW(colliders.moveTo("tnak", target), InvalidInput);
}

}  // namespace colliders_test
}  // namespace ice_ice_baby
