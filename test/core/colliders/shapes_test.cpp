// What single shapes answer about points and paths near them.
#include <gtest/gtest.h>

#include <cmath>

#include "colliders/colliders.h"
#include "fixtures.h"

namespace ice_ice_baby {
namespace shapes_test {

using test::Random;

constexpr double kRadius_m = 0.02;
constexpr double kReach_m = 0.15;

Container box(bool open_top) { return test::tankOf({0.8, 0.5, 0.6}, open_top); }

Plane plate() {
  Plane plane;
  plane.size_x_m = 0.6;
  plane.size_y_m = 0.4;
  plane.thickness_m = 0.05;
  return plane;
}

/// One collider of every shape and kind.
Scene everyShape() {
  Scene scene;
  scene.containers = {box(true), box(false)};
  scene.planes = {Plane(), plate()};
  scene.spheres.emplace_back().radius_m = 0.3;
  scene.boxes.emplace_back().size_m = {0.5, 0.3, 0.4};
  return scene;
}

Vec3d anyPoint(Random& random) { return random.inBox({-0.6, -0.6, -0.4}, {0.6, 0.6, 0.8}); }

/// Distances and normals against differences of distances.
TEST(ShapesTest, TheNormalIsTheGradientOfTheDistance) {
  const Scene scene = everyShape();
  const Colliders<double> colliders(scene, kRadius_m);
  Random random(11);
  std::size_t compared = 0;
  for (std::size_t c = 0; c < colliders.count(); ++c) {
    const Shape<double>& shape = colliders[c].shape;
    for (int k = 0; k < 2000; ++k) {
      const Vec3d point = anyPoint(random);
      const NearSurfaces<double> near = shape.near(point, kReach_m);
      for (int s = 0; s < near.count; ++s) {
        const NearSurface<double>& surface = near.begin()[s];
        ASSERT_LT(surface.distance, kReach_m);
        ASSERT_NEAR(surface.gap, surface.distance - kRadius_m, 1e-14);
        ASSERT_NEAR(surface.normal.norm(), 1.0, 1e-14);
        const double step = 1e-6;
        Vec3d gradient = Vec3d::Zero();
        bool same = true;
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3d e = step * Vec3d::Unit(axis);
          const auto above = shape.near(point + e, kReach_m),
                     below = shape.near(point - e, kReach_m);
          same = same && above.count == near.count && below.count == near.count;
          if (!same) break;
          gradient[axis] = (above.begin()[s].distance - below.begin()[s].distance) / (2 * step);
        }
        if (!same) continue;
        ASSERT_LT((gradient - surface.normal).norm(), 1e-8) << c << ": " << point.transpose();
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1500u);
}

/// What a surface is near to is what stops a path: a particle rests half a spacing from it.
TEST(ShapesTest, APathAgainstANearSurfaceEndsWhereAParticleTouchesIt) {
  const Scene scene = everyShape();
  const Colliders<double> colliders(scene, kRadius_m);
  Random random(12);
  std::array<std::size_t, 6> touched{};
  for (std::size_t c = 0; c < colliders.count(); ++c) {
    const Shape<double>& shape = colliders[c].shape;
    for (int k = 0; k < 4000; ++k) {
      const Vec3d point = anyPoint(random);
      const NearSurfaces<double> near = shape.near(point, kReach_m);
      if (near.count != 1) continue;  // beside an edge another surface may stop it first
      const NearSurface<double>& surface = *near.begin();
      if (surface.flatness == 0) continue;  // an edge, where contact has the corners of a box
      if (surface.distance <= kRadius_m) continue;
      const Vec3d to = point - (surface.distance + 0.005) * surface.normal;
      const NearSurfaces<double> end = shape.near(shape.resolve(point, to), kReach_m);
      ASSERT_GE(end.count, 1) << c << ": " << point.transpose();
      ASSERT_NEAR(end.begin()->distance, kRadius_m, 1e-12) << c << ": " << point.transpose();
      ++touched[c];
    }
  }
  for (const std::size_t count : touched) EXPECT_GT(count, 50u);
}

TEST(ShapesTest, WallsOfABoxAreAsFarAsItsSizeSays) {
  Scene scene;
  scene.containers = {box(false)};
  const Colliders<double> colliders(scene, kRadius_m);
  Random random(13);
  for (int k = 0; k < 2000; ++k) {
    const Vec3d point = random.inBox({-0.4, -0.25, 0}, {0.4, 0.25, 0.6});
    const Vec3d low = point - Vec3d(-0.4, -0.25, 0), high = Vec3d(0.4, 0.25, 0.6) - point;
    const auto near = colliders[0].shape.near(point, kReach_m);
    ASSERT_EQ(near.count, (low.array() < kReach_m).count() + (high.array() < kReach_m).count());
    for (const NearSurface<double>& wall : near) {
      const double along = wall.normal[wall.axis];
      ASSERT_NEAR(wall.distance, along > 0 ? low[wall.axis] : high[wall.axis], 1e-14);
      ASSERT_EQ(wall.normal, along * Vec3d::Unit(wall.axis));
      ASSERT_EQ(wall.flatness, 1.0);
      ASSERT_NEAR(wall.normal.dot(point - wall.resting), wall.distance - kRadius_m, 1e-14);
    }
  }
  EXPECT_EQ(colliders[0].shape.near({0.5, 0, 0.3}, kReach_m).count, 0) << "outside";
}

TEST(ShapesTest, AnOpenBoxHasNoLid) {
  Scene scene;
  scene.containers = {box(true)};
  const Colliders<double> colliders(scene, kRadius_m);
  EXPECT_EQ(colliders[0].shape.near({0, 0, 0.59}, kReach_m).count, 0);
  EXPECT_EQ(colliders[0].shape.near({0, 0, 0.01}, kReach_m).count, 1);
}

TEST(ShapesTest, AGroundIsNearFromAboveAlone) {
  Scene scene;
  scene.planes = {Plane()};
  const Colliders<double> colliders(scene, kRadius_m);
  const auto above = colliders[0].shape.near({0.1, -0.1, 0.07}, kReach_m);
  ASSERT_EQ(above.count, 1);
  EXPECT_NEAR(above.begin()->distance, 0.07, 1e-15);
  EXPECT_EQ(above.begin()->normal, Vec3d::UnitZ());
  EXPECT_EQ(colliders[0].shape.near({0, 0, -0.01}, kReach_m).count, 0);
  EXPECT_EQ(colliders[0].shape.near({0, 0, kReach_m}, kReach_m).count, 0);
  EXPECT_EQ(colliders[0].shape.near({9, 0, 0.07}, kReach_m).count, 1);
}

TEST(ShapesTest, ABallIsAsFarAsItsRadiusSaysAndFlatterTheNearer) {
  Scene scene;
  scene.spheres.emplace_back().radius_m = 0.3;
  const Colliders<double> colliders(scene, kRadius_m);
  Random random(14);
  for (int k = 0; k < 1000; ++k) {
    const Vec3d direction = random.direction();
    const double gap = random.uniform(-0.29, 0.149);
    const auto near = colliders[0].shape.near((0.3 + gap) * direction, kReach_m);
    ASSERT_EQ(near.count, 1);
    ASSERT_NEAR(near.begin()->distance, gap, 1e-14);
    ASSERT_LT((near.begin()->normal - direction).norm(), 1e-14);
    ASSERT_NEAR(near.begin()->flatness, gap > 0 ? 0.3 / (0.3 + gap) : 1.0, 1e-13);
  }
  EXPECT_EQ(colliders[0].shape.near(Vec3d::Zero(), kReach_m).count, 0) << "no nearest point";
}

/// Clearance is cautious: no shape pushes what it calls clear, nor what lies within the margin.
TEST(ShapesTest, NothingStopsAClearPath) {
  const Scene scene = everyShape();
  const Colliders<double> colliders(scene, kRadius_m);
  Random random(15);
  for (std::size_t c = 0; c < colliders.count(); ++c) {
    const Shape<double>& shape = colliders[c].shape;
    std::size_t clear = 0;
    for (int k = 0; k < 20000; ++k) {
      const double margin = random.uniform(0.0, 0.05);
      const Vec3d from = 2 * anyPoint(random), to = from + 0.2 * anyPoint(random);
      if (!shape.clear(from, to, margin)) continue;
      ++clear;
      const Vec3d aside = margin * random.uniform(0.0, 0.999) * random.direction();
      ASSERT_EQ(shape.resolve(from + aside, to + aside), to + aside) << c;
    }
    EXPECT_GT(clear, 1000u) << c;
  }
}

TEST(ShapesTest, OnlyWhatIsHollowHoldsAndHides) {
  const Scene scene = everyShape();
  const Colliders<double> colliders(scene, kRadius_m);
  const Vec3d inside(0.1, 0.1, 0.2), behind(0.1, 0.1, -0.01);
  for (std::size_t c = 0; c < colliders.count(); ++c) {
    const Shape<double>& shape = colliders[c].shape;
    EXPECT_EQ(shape.hollow(), c < 2);
    EXPECT_EQ(shape.closed(), c == 1);
    EXPECT_EQ(shape.holds(inside), shape.hollow());
    EXPECT_EQ(shape.hides(inside, behind, 0.0), shape.hollow());
    EXPECT_FALSE(shape.hides(inside, behind, 0.02)) << "within the slack";
    EXPECT_FALSE(shape.hides(behind, inside, 0.0)) << "from without";
    EXPECT_EQ(shape.flat(), c != 4);
    EXPECT_EQ(shape.rim({0, 0, 0.55}, kReach_m).has_value(), c == 0);
  }
}

TEST(ShapesTest, AnswerAlikeInFloat) {
  const Scene scene = everyShape();
  const Colliders<double> exact(scene, kRadius_m);
  const Colliders<float> single(scene, kRadius_m);
  Random random(16);
  for (std::size_t c = 0; c < exact.count(); ++c) {
    const Shape<double> shape = single[c].shape.cast<double>();
    EXPECT_NEAR(shape.turningRadius(3.0), exact[c].shape.turningRadius(3.0), 1e-6);
    for (int k = 0; k < 1000; ++k) {
      const Vec3d from = anyPoint(random), to = anyPoint(random);
      const Vec3d a = shape.resolve(from, from), b = exact[c].shape.resolve(from, from);
      ASSERT_LT((a - b).norm(), 1e-6) << c << ": " << from.transpose();
      ASSERT_EQ(shape.holds(to), exact[c].shape.holds(to));
    }
  }
}

}  // namespace shapes_test
}  // namespace ice_ice_baby
