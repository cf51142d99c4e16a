// Solid boxes, and the plates that are boxes too, in every orientation.
#include <gtest/gtest.h>

#include <cmath>

#include "colliders/collider_faces.h"
#include "fixtures.h"

namespace ice_ice_baby {
namespace box_shape_test {

using test::Random;

constexpr double kRadius_m = 0.02;
constexpr double kReach_m = 0.15;
const Vec3d kSize_m(0.5, 0.3, 0.4);

Scene withBox(const Vec3d& position_m, const Vec3d& rpy_deg) {
  Scene scene;
  Box& box = scene.boxes.emplace_back();
  box.name = "box";
  box.size_m = kSize_m;
  box.position_m = position_m;
  box.rpy_deg = rpy_deg;
  return scene;
}

/// The same solid as a plate, whose position is the centre of its top.
Scene withPlate(const Vec3d& position_m, const Vec3d& rpy_deg) {
  Scene scene;
  Plane& plate = scene.planes.emplace_back();
  plate.name = "plate";
  plate.size_x_m = kSize_m.x();
  plate.size_y_m = kSize_m.y();
  plate.thickness_m = kSize_m.z();
  plate.rpy_deg = rpy_deg;
  plate.position_m =
      position_m + poseOf(Vec3d::Zero(), rpy_deg).rotation * Vec3d(0, 0, kSize_m.z() / 2);
  return scene;
}

/// Upright, each face up, and oblique.
std::vector<Vec3d> orientations() {
  return {{0, 0, 0},  {90, 0, 0},  {-90, 0, 0}, {180, 0, 0},
          {0, 90, 0}, {0, -90, 0}, {0, 0, 45},  {30, -50, 20}};
}

Vec3d closestOf(const Vec3d& local) { return local.cwiseMax(-kSize_m / 2).cwiseMin(kSize_m / 2); }

TEST(BoxShapeTest, TheNearSurfaceIsTheClosestPoint) {
  const Colliders<double> colliders(withBox(Vec3d::Zero(), Vec3d::Zero()), kRadius_m);
  const Shape<double>& shape = colliders[0].shape;
  Random random(21);
  std::array<int, 4> beyond{};
  for (int k = 0; k < 20000; ++k) {
    const Vec3d point = random.inBox(-kSize_m, kSize_m), apart = point - closestOf(point);
    const auto axes = std::size_t((apart.array() != 0).count());
    if (axes == 0) continue;
    const NearSurfaces<double> near = shape.near(point, kReach_m);
    ASSERT_EQ(near.count, apart.norm() < kReach_m ? 1 : 0) << point.transpose();
    if (near.count == 0) continue;
    const NearSurface<double>& surface = *near.begin();
    ++beyond[axes];
    ASSERT_NEAR(surface.distance, apart.norm(), 1e-14);
    ASSERT_LT((surface.normal - apart.normalized()).norm(), 1e-12);
    ASSERT_EQ(surface.flatness, axes == 1 ? 1.0 : 0.0);
    if (axes > 1) continue;
    ASSERT_EQ(std::abs(surface.normal[surface.axis]), 1.0);
    ASSERT_NEAR(surface.normal.dot(point - surface.resting), surface.gap, 1e-14);
  }
  for (const std::size_t axes : {1u, 2u, 3u}) EXPECT_GT(beyond[axes], 100) << axes;
}

TEST(BoxShapeTest, APointInsideIsNearestToTheFaceOutOfWhichItIsPushed) {
  const Colliders<double> colliders(withBox(Vec3d::Zero(), Vec3d::Zero()), kRadius_m);
  const Shape<double>& shape = colliders[0].shape;
  Random random(22);
  for (int k = 0; k < 1000; ++k) {
    const Vec3d point = random.inBox(-0.499 * kSize_m, 0.499 * kSize_m);
    const NearSurfaces<double> near = shape.near(point, kReach_m);
    ASSERT_EQ(near.count, 1);
    const Vec3d pushed = point - near.begin()->gap * near.begin()->normal;
    ASSERT_LT((shape.resolve(point, point) - pushed).norm(), 1e-12) << point.transpose();
  }
}

TEST(BoxShapeTest, APlateIsABox) {
  for (const Vec3d& rpy : orientations()) {
    const Colliders<double> box(withBox({1, -2, 3}, rpy), kRadius_m);
    const Colliders<double> plate(withPlate({1, -2, 3}, rpy), kRadius_m);
    Random random(23);
    for (int k = 0; k < 1000; ++k) {
      const Vec3d from = Vec3d(1, -2, 3) + random.inBox(-kSize_m, kSize_m);
      const Vec3d to = Vec3d(1, -2, 3) + random.inBox(-kSize_m, kSize_m);
      ASSERT_LT((box.respond(from, to, false) - plate.respond(from, to, false)).norm(), 1e-12);
      const auto a = box[0].shape.near(box[0].motion.to.toLocal(from), kReach_m);
      const auto b = plate[0].shape.near(plate[0].motion.to.toLocal(from), kReach_m);
      ASSERT_EQ(a.count, b.count);
      if (a.count == 0) continue;
      ASSERT_NEAR(a.begin()->distance, b.begin()->distance, 1e-12);
      ASSERT_LT((a.begin()->normal - b.begin()->normal).norm(), 1e-9);
    }
  }
}

TEST(BoxShapeTest, NothingEndsInsideOrPassesThrough) {
  for (const Vec3d& rpy : orientations()) {
    const Vec3d centre(-3, 2, 1);
    const Colliders<float> colliders(withBox(centre, rpy), kRadius_m);
    const Posed pose = poseOf(centre, rpy);
    Random random(24);
    for (int k = 0; k < 2000; ++k) {
      const Vec3d aside = random.inBox(-0.4 * kSize_m, 0.4 * kSize_m);
      const Vec3d way = 2 * kSize_m.maxCoeff() * random.direction();
      const Vec3<float> from = (pose.toWorld(aside) + way).cast<float>();
      const Vec3<float> to = (pose.toWorld(aside) - way).cast<float>();
      const Vec3d end = pose.toLocal(colliders.respond(from, to, false).cast<double>());
      const Vec3d start = pose.toLocal(from.cast<double>());
      ASSERT_GT((end.cwiseAbs() - kSize_m / 2).maxCoeff(), kRadius_m - 1e-5) << rpy.transpose();
      bool stopped = false;  // beyond a side of the box beyond which it started
      for (int a = 0; a < 3; ++a) {
        const double side = kSize_m[a] / 2 + kRadius_m - 1e-5;
        stopped = stopped ||
                  (std::abs(start[a]) > side && end[a] * start[a] > 0 && std::abs(end[a]) >= side);
      }
      ASSERT_TRUE(stopped) << rpy.transpose() << ": " << start.transpose();
    }
  }
}

TEST(BoxShapeTest, IceRestsOnEveryFace) {
  for (const Vec3d& rpy : orientations()) {
    const Vec3d centre(0.3, 0.4, 0.5);
    const Colliders<double> colliders(withBox(centre, rpy), kRadius_m);
    ColliderFaces faces;
    faces.take(colliders);
    const Posed pose = poseOf(centre, rpy);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const Vec3d normal = side * Vec3d::Unit(axis);
        const double height = kSize_m[axis] / 2 + kRadius_m;
        const Vec3d above = pose.toWorld((height + 0.001) * normal);
        const Vec3d below = pose.toWorld((height - 0.001) * normal);
        std::array<Face, 6> found;
        for (const Vec3d& to : {above, below}) {
          ASSERT_EQ(faces.find(0, above, to, 0.005, found), 1u) << rpy.transpose();
          EXPECT_LT((found[0].normal - pose.rotation * normal).norm(), 1e-12);
          EXPECT_NEAR(found[0].gap_m, to == above ? 0.001 : -0.001, 1e-12);
        }
      }
    }
  }
}

}  // namespace box_shape_test
}  // namespace ice_ice_baby
