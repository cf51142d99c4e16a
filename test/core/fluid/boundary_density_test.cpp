#include "fluid/boundary_density.h"

#include <gtest/gtest.h>

#include <memory>

#include "fluid/walls.h"

namespace ice_ice_baby {
namespace boundary_density_test {

using test::Walls;

constexpr double kSpacing_m = test::kWallSpacing_m;
constexpr double kSupport_m = test::kWallSupport_m;
/// Cell of the table of planes; slopes are constant within a cell, so differences stay inside one.
constexpr double kCell_m = kSupport_m / 512;

Scene tank(bool open_top) {
  Scene scene = test::sceneOfWalls();
  scene.containers.push_back(test::tankOf(Vec3d::Constant(0.4), open_top));
  return scene;
}

/// Compares the gradient with a central difference within a cell of the tables.
void expectGradient(const Walls& walls, const Vec3d& point, double tolerance) {
  const Vec3d gradient = walls.density.at(point).gradient;
  const double step = 1e-3 * kCell_m;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d e = step * Vec3d::Unit(axis);
    const double difference = (walls.at(point + e) - walls.at(point - e)) / (2 * step);
    EXPECT_NEAR(gradient[axis], difference, tolerance) << "at " << point.transpose();
  }
}

/// Distances to a wall in the middle of table cells, from touching to out of reach.
const double kDistances[] = {20.5 * kCell_m, 128.5 * kCell_m, 250.5 * kCell_m, 470.5 * kCell_m,
                             600.5 * kCell_m};

TEST(BoundaryDensityTest, PlaneGradientIsTheDifferenceOfItsValue) {
  Scene scene = test::sceneOfWalls();
  scene.planes.emplace_back();
  const Walls walls(scene);
  for (const double z : kDistances) expectGradient(walls, {0.3, -7, z}, 1e-8);
}

TEST(BoundaryDensityTest, TiltedPlaneCountsByItsNormalDistance) {
  Scene scene = test::sceneOfWalls();
  scene.planes.emplace_back();
  const Walls flat(scene);
  scene.planes[0].rpy_deg = {30, -50, 70};
  scene.planes[0].position_m = {1, 2, 3};
  const Walls tilted(scene);
  const Posed pose = scene.planes[0].pose();
  for (const double z : kDistances) {
    const Vec3d point = pose.toWorld({0.4, 0.1, z});
    EXPECT_NEAR(tilted.at(point), flat.at({0.4, 0.1, z}), 1e-12);
    const Vec3d turned = pose.rotation * flat.density.at({0.4, 0.1, z}).gradient;
    EXPECT_LT((tilted.density.at(point).gradient - turned).norm(), 1e-9);
  }
}

TEST(BoundaryDensityTest, BoxGradientOnFacesEdgesAndCorners) {
  const Walls walls(tank(false));
  for (const double a : kDistances) {
    expectGradient(walls, {-0.2 + a, 0.003, 0.2}, 1e-8);
    expectGradient(walls, {0.2 - a, 0.003, 0.2}, 1e-8);
    for (const double b : kDistances) {
      expectGradient(walls, {-0.2 + a, 0.2 - b, 0.2}, 1e-8);
      for (const double c : kDistances) {
        expectGradient(walls, {-0.2 + a, -0.2 + b, c}, 1e-8);
        expectGradient(walls, {0.2 - a, -0.2 + b, 0.4 - c}, 1e-8);
      }
    }
  }
}

TEST(BoundaryDensityTest, RimGradientIsTheDifferenceOfItsValue) {
  const Walls walls(tank(true));
  for (const double a : kDistances) {
    for (const double b : kDistances) {
      for (const double z : {0.4 - b, 0.4 + b}) {
        expectGradient(walls, {0.003, -0.2 + a, z}, 1e-8);
        expectGradient(walls, {-0.2 + kDistances[2], -0.2 + a, z}, 1e-8);
      }
    }
  }
}

TEST(BoundaryDensityTest, NothingAwayFromWallsOrOutside) {
  const Walls walls(tank(false));
  EXPECT_EQ(walls.at({0, 0, 0.2}), 0.0);
  EXPECT_EQ(walls.at({0.5, 0, 0.2}), 0.0);
  EXPECT_EQ(walls.at({0, 0, -0.3}), 0.0);
  EXPECT_EQ(walls.density.at({0, 0, 0.2}).gradient.norm(), 0.0);
}

TEST(BoundaryDensityTest, OpenTopHasNoLid) {
  const Walls open(tank(true)), closed(tank(false));
  EXPECT_EQ(open.at({0, 0, 0.38}), 0.0);
  EXPECT_GT(closed.at({0, 0, 0.38}), 0.1);
  EXPECT_NEAR(open.at({0.01, 0.02, 0.02}), closed.at({0.01, 0.02, 0.02}), 1e-14);
}

TEST(BoundaryDensityTest, WhatIsBehindAWallOfTheContainerDoesNotCount) {
  const Walls alone(tank(true));
  Scene scene = tank(true);
  scene.planes.emplace_back();
  scene.spheres.emplace_back();
  scene.spheres[0].position_m = {0.32, 0, 0.2};
  const Walls grounded(scene);
  const Walls ball_only([&] {
    Scene inside = tank(true);
    inside.spheres = scene.spheres;
    inside.spheres[0].position_m = {0, 0, 0.2};
    return inside;
  }());
  for (const double a : kDistances) {
    EXPECT_NEAR(grounded.at({0, 0, a}), alone.at({0, 0, a}), 4e-3) << "ground under the floor";
    EXPECT_NEAR(grounded.at({0.2 - a, 0, 0.2}), alone.at({0.2 - a, 0, 0.2}), 1e-4)
        << "ball outside";
  }
  EXPECT_GT(ball_only.at({0, 0, 0.325}), 0.1) << "a ball inside counts";
  EXPECT_GT(grounded.at({1, 0, 0.025}), 0.1) << "the ground beside the tank counts";
}

TEST(BoundaryDensityTest, BoxIsTheSameFromEverySide) {
  const Walls walls(tank(false));
  for (const double a : kDistances) {
    const double floor = walls.at({0, 0, a});
    EXPECT_NEAR(walls.at({0, 0, 0.4 - a}), floor, 1e-10);
    EXPECT_NEAR(walls.at({-0.2 + a, 0, 0.2}), floor, 1e-10);
    EXPECT_NEAR(walls.at({0, 0.2 - a, 0.2}), floor, 1e-10);
  }
}

TEST(BoundaryDensityTest, ValueIsTheLatticeThatGoesOnBehindTheWall) {
  Scene scene = test::sceneOfWalls();
  scene.planes.emplace_back();
  const Walls walls(scene);
  const CubicSpline<double> kernel(kSupport_m);
  const double volume = 1 / latticeSum(kernel, kSpacing_m, true);
  for (const double z : {0.0, 0.025, 0.05, 0.075}) {
    double sum = 0;
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (int k = 0; k < 3; ++k) {
          sum += kernel.w(kSpacing_m * Vec3d(x, y, k + 0.5 + z / kSpacing_m).norm());
        }
      }
    }
    EXPECT_NEAR(walls.at({0, 0, z}), volume * sum, 1e-9) << z;
  }
}

TEST(BoundaryDensityTest, SphereGradientIsTheDifferenceOfItsValue) {
  Scene scene = test::sceneOfWalls();
  scene.spheres.emplace_back();
  scene.spheres[0].radius_m = 0.3;
  scene.spheres[0].position_m = {1, -2, 0.5};
  const Walls walls(scene);
  test::Random random(31);
  for (const double distance : kDistances) {
    for (int k = 0; k < 20; ++k) {
      // 1e-6: off the axes the direction turns within the step.
      expectGradient(walls, scene.spheres[0].position_m + (0.3 + distance) * random.direction(),
                     1e-6);
    }
  }
}

TEST(BoundaryDensityTest, HugeSphereIsAFlatWall) {
  Scene scene = test::sceneOfWalls();
  scene.spheres.emplace_back();
  scene.spheres[0].radius_m = 100;
  const Walls walls(scene);
  Scene flat = test::sceneOfWalls();
  flat.planes.emplace_back();
  const Walls ground(flat);
  // A ball of 100 m dips below its tangent plane by h^2 / 2 R = 5e-5 m, that is 1e-3 of 1 / h.
  for (const double z : {0.0, 0.02, 0.05, 0.08, 0.099}) {
    EXPECT_NEAR(walls.at({0, 0, 100 + z}), ground.at({0, 0, z}), 2e-3) << z;
  }
}

TEST(BoundaryDensityTest, SphereGrowsWithItsRadiusAndNeverExceedsAHalfSpace) {
  Scene ground = test::sceneOfWalls();
  ground.planes.emplace_back();
  const double flat = Walls(ground).at({0, 0, 0.025});
  double before = 0;
  for (const double radius : {0.01, 0.05, 0.2, 1.0, 50.0}) {
    Scene scene = test::sceneOfWalls();
    scene.spheres.emplace_back();
    scene.spheres[0].radius_m = radius;
    const double value = Walls(scene).at({0, 0, radius + 0.025});
    EXPECT_GT(value, before);
    EXPECT_LE(value, flat + 1e-6);
    before = value;
  }
}

TEST(BoundaryDensityTest, AllIsFiniteAtTheCentreOfASphereAndInsideWalls) {
  Scene scene = tank(false);
  scene.spheres.emplace_back();
  scene.spheres[0].position_m = {0, 0, 0.2};
  const Walls walls(scene);
  test::Random random(32);
  for (int k = 0; k < 2000; ++k) {
    const Vec3d point = k == 0 ? Vec3d(0, 0, 0.2) : random.inBox({-1, -1, -1}, {1, 1, 1});
    const auto sample = walls.density.at(point);
    EXPECT_TRUE(std::isfinite(sample.value) && sample.gradient.allFinite());
    EXPECT_GE(sample.value, -1e-9);
  }
}

TEST(BoundaryDensityTest, FloatAgreesWithDouble) {
  const Scene scene = tank(true);
  const Walls walls(scene);
  const Colliders<float> colliders(scene, kSpacing_m / 2);
  const BoundaryDensity<float> single(
      scene, colliders, particleMass_kg(scene.fluid, kSupport_m) / scene.fluid.rest_density_kg_m3);
  test::Random random(33);
  for (int k = 0; k < 500; ++k) {
    const Vec3d point = random.inBox({-0.17, -0.17, 0.03}, {0.17, 0.17, 0.37});
    EXPECT_NEAR(single.at(point.cast<float>()).value, walls.at(point), 2e-5);
  }
}

}  // namespace boundary_density_test
}  // namespace ice_ice_baby
