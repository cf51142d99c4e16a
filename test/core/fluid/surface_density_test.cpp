// Density beside surfaces of triangles, against flat walls, boxes and direct integration.
#include "fluid/surface_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fluid/walls.h"
#include "meshes/meshes.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby {
namespace surface_density_test {

using test::Random;
using test::Walls;

constexpr double d = test::kWallSpacing_m;

Walls withMesh(const TriangleMesh& triangles, const Posed& = {}) {
  Scene scene = test::sceneOfWalls();
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.name = "mesh";
  mesh.triangles = std::make_shared<const TriangleMesh>(triangles);
  return Walls(scene);
}

Walls withGround() {
  Scene scene = test::sceneOfWalls();
  scene.planes.emplace_back();
  return Walls(scene);
}

/// A single sheet at z = 0.
TriangleMesh sheet(double half_m) {
  TriangleMesh mesh;
  mesh.vertices = {
      {-half_m, -half_m, 0}, {half_m, -half_m, 0}, {half_m, half_m, 0}, {-half_m, half_m, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Thick, thin and without thickness, a wide wall counts as flat on each side.
TEST(SurfaceDensityTest, AWideWallIsAFlatWallToEachSide) {
  const Walls ground = withGround();
  Random random(1);
  for (const double thickness_d : {0.0, 0.02, 0.1, 0.3, 2.0}) {
    const Vec3d low(-0.5, -0.5, -thickness_d * d), high(0.5, 0.5, 0);
    const Walls wall = withMesh(thickness_d == 0.0 ? sheet(0.5) : test::boxMesh(low, high, 3));
    for (int k = 0; k < 300; ++k) {
      const double height = random.uniform(0.5, 1.6) * d;
      const Vec3d at = random.inBox({-0.3, -0.3, height}, {0.3, 0.3, height});
      const Vec3d below(at.x(), at.y(), -thickness_d * d - height);
      ASSERT_NEAR(wall.at(at), ground.at(at), 2e-3) << thickness_d << ", " << height / d;
      ASSERT_NEAR(wall.at(below), ground.at(at), 2e-3) << thickness_d << ", " << height / d;
    }
  }
}

/// Kernels reach as far as four spacings.
TEST(SurfaceDensityTest, AWideWallIsAFlatWallToKernelsOfAnyWidth) {
  for (const double support_d : {1.5, 3.0, 4.0}) {
    Scene scene = test::sceneOfWalls();
    scene.fluid.support_radius_m = support_d * d;
    scene.planes.emplace_back();
    const Colliders<double> plane(scene, d / 2);
    const BoundaryDensity<double> exact(scene, plane, d * d * d);
    scene.planes.clear();
    scene.meshes.emplace_back().triangles =
        std::make_shared<const TriangleMesh>(test::boxMesh({-0.5, -0.5, -0.3}, {0.5, 0.5, 0}, 2));
    const Colliders<double> mesh(scene, d / 2);
    const BoundaryDensity<double> sampled(scene, mesh, d * d * d);
    for (double height = 0.5; height < support_d; height += 0.1) {
      const Vec3d at(0.013, 0.027, height * d);
      ASSERT_NEAR(sampled.at(at).value, exact.at(at).value, 2e-3) << support_d << ", " << height;
    }
  }
}

TEST(SurfaceDensityTest, ABoxOfTrianglesIsABox) {
  Scene scene = test::sceneOfWalls();
  Plane& plate = scene.planes.emplace_back();
  plate.size_x_m = 5 * d;
  plate.size_y_m = 4 * d;
  plate.thickness_m = 3 * d;
  const Walls exact(scene);
  const Walls mesh = withMesh(test::boxMesh({-2.5 * d, -2 * d, -3 * d}, {2.5 * d, 2 * d, 0}, 4));
  Random random(2);
  int compared = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3d at = random.inBox({-4 * d, -4 * d, -5 * d}, {4 * d, 4 * d, 2 * d});
    if (mesh.colliders[0].shape.solid(at)) continue;
    if (mesh.colliders[0].shape.near(at, 0.499 * d).count > 0) continue;
    ASSERT_NEAR(mesh.at(at), exact.at(at), 2.5e-3) << (at / d).transpose();
    compared += exact.at(at) > 0.01;
  }
  EXPECT_GT(compared, 1500);
}

/// The gradient belongs to the value, so that no energy comes from it.
TEST(SurfaceDensityTest, TheGradientIsThatOfTheValue) {
  Scene scene = test::sceneOfWalls();
  Cup& cup = scene.cups.emplace_back();
  cup.name = "cup";
  cup.radius_m = 3 * d;
  cup.depth_m = 5 * d;
  cup.wall_m = 0.1 * d;
  cup.rpy_deg = {20, 30, 40};
  const Walls walls(scene);
  Random random(3);
  int compared = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3d at = random.inBox(Vec3d::Constant(-7 * d), Vec3d::Constant(7 * d));
    const auto sample = walls.density.at(at);
    if (sample.value == 0 ||
        walls.colliders[0].shape.near(walls.colliders[0].motion.to.toLocal(at), 0.49 * d).count > 0)
      continue;
    const double step = 1e-5 * d;
    Vec3d gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d e = step * Vec3d::Unit(axis);
      gradient[axis] = (walls.at(at + e) - walls.at(at - e)) / (2 * step);
    }
    ASSERT_LT((gradient - sample.gradient).norm() * d, 1e-4) << (at / d).transpose();
    ++compared;
  }
  EXPECT_GT(compared, 3000);
}

/// A lattice cut to the inside of a round cup has about the density of water at rest at its wall:
/// the solid behind a wall that bends inwards adds more than a flat one.
TEST(SurfaceDensityTest, ARoundWallAddsWhatTheSolidBehindItHolds) {
  const Walls flat = withGround();
  Scene scene = test::sceneOfWalls();
  Cup& cup = scene.cups.emplace_back();
  cup.name = "cup";
  cup.radius_m = 4 * d;
  cup.depth_m = 10 * d;
  cup.wall_m = 2 * d;
  const Walls round(scene);
  const double at_flat = flat.at({0, 0, 0.5 * d});
  EXPECT_NEAR(at_flat, 0.150, 0.002);
  EXPECT_NEAR(round.at({3.5 * d, 0, 5 * d}), 0.165, 0.003);
  Scene ball_scene = test::sceneOfWalls();
  Capsule& capsule = ball_scene.capsules.emplace_back();
  capsule.radius_m = 2 * d;
  capsule.length_m = 1e-3;
  EXPECT_NEAR(Walls(ball_scene).at({2.5 * d, 0, 0}), 0.107, 0.003);
}

/// A thin rod hides nothing: it counts with its own volume.
TEST(SurfaceDensityTest, AThinRodCountsWithItsVolume) {
  Scene scene = test::sceneOfWalls();
  Cylinder& rod = scene.cylinders.emplace_back();
  rod.radius_m = 0.1 * d;
  rod.height_m = 10 * d;
  const Walls thin(scene);
  scene.cylinders[0].radius_m = 0.2 * d;
  const Walls twice(scene);
  const double one = thin.at({0.7 * d, 0, 0}), four = twice.at({0.8 * d, 0, 0});
  EXPECT_LT(one, 0.02);
  EXPECT_GT(one, 0.0);
  EXPECT_LT(four, 6 * one);
}

}  // namespace surface_density_test
}  // namespace ice_ice_baby
