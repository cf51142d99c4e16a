// Density of solids: boxes, balls and planes, and what they share, against direct integration.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fluid/walls.h"

namespace ice_ice_baby {
namespace solid_density_test {

using test::Walls;

constexpr double kSpacing_m = test::kWallSpacing_m, kSupport_m = test::kWallSupport_m;

Plane plate(const Vec3d& size_m, const Vec3d& top_m, const Vec3d& rpy_deg = Vec3d::Zero()) {
  Plane plane;
  plane.name = "plate";
  plane.size_x_m = size_m.x();
  plane.size_y_m = size_m.y();
  plane.thickness_m = size_m.z();
  plane.position_m = top_m;
  plane.rpy_deg = rpy_deg;
  return plane;
}

Walls withPlate(const Plane& plane) {
  Scene scene = test::sceneOfWalls();
  scene.planes.push_back(plane);
  return Walls(scene);
}

/// T of a flat wall, as the lattice behind it.
WallKernel kernel() {
  const Scene scene = test::sceneOfWalls();
  const RestLattice lattice(
      scene, particleMass_kg(scene.fluid, kSupport_m) / scene.fluid.rest_density_kg_m3);
  return WallKernel([&](double s) { return lattice.behind({s, 0, 0}, 1); }, kSupport_m);
}

/// Integral of the kernel over what `holds` says, seen from the origin, over a fine lattice.
template <class Holds>
double integral(const WallKernel& kernel, const Holds& holds) {
  const int n = 60;
  const double cell = 0.8 * kSupport_m / n;
  double sum = 0.0;
  for (int i = -n; i < n; ++i) {
    for (int j = -n; j < n; ++j) {
      for (int k = -n; k < n; ++k) {
        const Vec3d point = cell * (Vec3d(i, j, k) + Vec3d::Constant(0.5));
        if (holds(point)) sum += kernel.value(point.norm()) * cell * cell * cell;
      }
    }
  }
  return sum;
}

TEST(WallKernelTest, AHalfSpaceOfItIsAFlatWall) {
  const WallKernel w = kernel();
  for (const double s : {0.2, 0.5, 0.8, 1.2}) {
    // Planes that lie between the cells of the lattice are exact.
    const double cell = 0.8 * kSupport_m / 60, edge = std::round(s * kSpacing_m / cell) * cell;
    EXPECT_NEAR(integral(w, [&](const Vec3d& p) { return p.z() > edge; }), w.halfSpace(edge), 3e-4);
  }
  EXPECT_EQ(w.halfSpace(kSupport_m), 0.0);
}

TEST(BoxDensityTest, IsTheIntegralOverTheBox) {
  const WallKernel w = kernel();
  const double cell = 0.8 * kSupport_m / 60;
  test::Random random(7);
  for (int trial = 0; trial < 40; ++trial) {
    AlignedBox<double> box;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = cell * std::round(random.uniform(-60, 40));
      box.low[axis] = low;
      box.high[axis] = low + cell * std::round(random.uniform(4, 80));
    }
    const double direct = integral(w, [&](const Vec3d& p) { return box.holds(p); });
    EXPECT_NEAR(BoxDensity<double>(w).at(box).value, direct, 5e-4 + 2e-3 * direct);
  }
}

TEST(BoxDensityTest, ALargePlateIsAFlatWall) {
  const Walls walls = withPlate(plate({1, 1, 0.2}, {0, 0, 0}));
  Scene scene = test::sceneOfWalls();
  scene.planes.emplace_back();
  const Walls ground(scene);
  for (double s = 0.4; s < 1.6; s += 0.05) {
    EXPECT_NEAR(walls.at({0.1, 0.2, s * kSpacing_m}), ground.at({0, 0, s * kSpacing_m}), 3e-4) << s;
    EXPECT_NEAR(walls.at({0.5 + s * kSpacing_m, 0.2, -0.1}), ground.at({0, 0, s * kSpacing_m}),
                3e-4)
        << "side " << s;
    EXPECT_NEAR(walls.at({0.1, 0.2, -0.2 - s * kSpacing_m}), ground.at({0, 0, s * kSpacing_m}),
                3e-4)
        << "below " << s;
  }
}

TEST(OverlapTest, IsTheIntegralBehindBothPlanes) {
  const WallKernel w = kernel();
  const OverlapDensity<double> overlap(w);
  for (const double angle : {30.0, 45.0, 60.0, 90.0, 120.0, 135.0}) {
    const double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
    for (const auto& distances : {std::pair{0.5, 0.5}, {0.5, 0.9}, {1.1, 0.6}}) {
      const double a = distances.first, b = distances.second;
      const double direct = integral(w, [&](const Vec3d& p) {
        return p.z() > a * kSpacing_m && c * p.z() + s * p.x() > b * kSpacing_m;
      });
      EXPECT_NEAR(overlap.at(a * kSpacing_m, b * kSpacing_m, c).value, direct, 2e-3)
          << angle << " " << a << " " << b;
    }
  }
}

TEST(OverlapTest, ParallelPlanesShareTheFartherOne) {
  const WallKernel w = kernel();
  const OverlapDensity<double> overlap(w);
  for (const double b : {0.7, 1.0, 1.3}) {
    EXPECT_NEAR(overlap.at(0.5 * kSpacing_m, b * kSpacing_m, 1.0).value,
                w.halfSpace(b * kSpacing_m), 2e-3);
  }
  EXPECT_NEAR(overlap.at(0.5 * kSpacing_m, 0.5 * kSpacing_m, -1.0).value, 0.0, 1e-4);
}

/// A tank with a chamfer, a step, a shelf, a ball and a ground flush with its floor.
Scene crowded(const Vec3d& place = Vec3d::Zero()) {
  Scene scene = test::sceneOfWalls();
  scene.containers.push_back(test::tankOf({0.8, 0.5, 0.6}, true));
  scene.planes.push_back(plate({0.4, 0.5, 0.1}, {0.3, 0, 0.1}, {0, -45, 0}));
  scene.planes.push_back(plate({0.2, 0.2, 0.2}, {-0.3, 0.15, 0.2}));
  scene.planes.push_back(plate({0.2, 0.2, 0.05}, {0, 0, 0.35}, {10, 5, 30}));
  scene.planes.emplace_back();
  scene.spheres.emplace_back();
  scene.spheres[0].radius_m = 0.08;
  scene.spheres[0].position_m = {-0.05, -0.12, 0.07};
  for (auto& container : scene.containers) container.position_m += place;
  for (auto& plane : scene.planes) plane.position_m += place;
  scene.spheres[0].position_m += place;
  return scene;
}

/// Points at least half a spacing from every solid, as particles are.
std::vector<Vec3d> freePoints(const Walls& walls, int wanted, const Vec3d& place) {
  test::Random random(11);
  std::vector<Vec3d> points;
  while (int(points.size()) < wanted) {
    const Vec3d point = place + random.inBox({-0.375, -0.225, 0.025}, {0.375, 0.225, 0.66});
    bool free = true;
    for (const auto& collider : walls.colliders) {
      const Vec3d local = collider.motion.to.toLocal(point);
      free = free && (collider.shape.resolve(local, local) - local).norm() < 1e-9;
    }
    if (free && walls.at(point) > 0) points.push_back(point);
  }
  return points;
}

TEST(SolidDensityTest, TheGradientIsTheDifferenceOfTheValue) {
  for (const Vec3d& place : {Vec3d(0, 0, 0), Vec3d(7, -3, 2)}) {
    const Walls walls(crowded(place));
    int apart = 0;
    for (const Vec3d& point : freePoints(walls, 3000, place)) {
      const Vec3d gradient = walls.density.at(point).gradient;
      Vec3d difference;
      const double step = 1e-7 * kSpacing_m;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3d e = step * Vec3d::Unit(axis);
        difference[axis] = (walls.at(point + e) - walls.at(point - e)) / (2 * step);
      }
      if ((gradient - difference).norm() * kSpacing_m > 1e-3) ++apart;
    }
    EXPECT_LE(apart, 3);  // where the step crosses a cell of a table
  }
}

TEST(SolidDensityTest, NothingJumps) {
  const Walls walls(crowded());
  test::Random random(12);
  const double step = 1e-3 * kSpacing_m;
  double largest = 0.0;
  for (const Vec3d& start : freePoints(walls, 400, Vec3d::Zero())) {
    const Vec3d way = step * random.direction();
    double before = walls.at(start);
    for (int k = 1; k < 400; ++k) {
      const Vec3d point = start + k * way;
      bool free = point.z() > 0.025;
      for (const auto& collider : walls.colliders) {
        const Vec3d local = collider.motion.to.toLocal(point);
        free = free && (collider.shape.resolve(local, local) - local).norm() < 1e-9;
      }
      if (!free) break;
      const double now = walls.at(point);
      largest = std::max(largest, std::abs(now - before));
      before = now;
    }
  }
  EXPECT_LT(largest,
            2e-3);  // a slope of 1 per spacing gives 1e-3; a plate's edge used to give 0.48
}

TEST(SolidDensityTest, AGroundBelowOrFlushWithTheFloorAddsNothing) {
  Scene scene = test::sceneOfWalls();
  scene.containers.push_back(test::tankOf({0.8, 0.5, 0.6}, true));
  const Walls alone(scene);
  scene.planes.emplace_back();
  for (const double below : {0.0, 0.003, 0.02, 0.05}) {
    scene.planes[0].position_m.z() = -below;
    const Walls both(scene);
    for (const double x : {0.0, 0.34, 0.375}) {
      for (const double z : {0.025, 0.04, 0.06, 0.08}) {
        EXPECT_NEAR(both.at({x, 0.1, z}), alone.at({x, 0.1, z}), 4e-3) << below << " " << x << z;
      }
    }
  }
}

/// Density of a lattice at rest, with its walls, at a point of it.
double restDensity(const Walls& walls, const std::vector<Vec3d>& lattice, const Vec3d& point) {
  const CubicSpline<double> w(kSupport_m);
  const double volume = 1 / latticeSum(w, kSpacing_m, true);
  double sum = 0.0;
  for (const Vec3d& other : lattice) sum += w.w((other - point).norm());
  return volume * sum + walls.at(point);
}

TEST(SolidDensityTest, WaterAtRestAroundAStepHasItsRestDensity) {
  Scene scene = test::sceneOfWalls();
  scene.containers.push_back(test::tankOf({0.8, 0.5, 0.6}, false));
  scene.planes.push_back(plate({0.2, 0.5, 0.2}, {0.3, 0, 0.2}));  // a step along the right wall
  const Walls walls(scene);
  std::vector<Vec3d> lattice;
  for (double x = -0.375; x < 0.4; x += kSpacing_m) {
    for (double y = -0.225; y < 0.25; y += kSpacing_m) {
      for (double z = 0.025; z < 0.6; z += kSpacing_m) {
        if (x < 0.2 || z > 0.2) lattice.emplace_back(x, y, z);
      }
    }
  }
  for (const Vec3d& point : lattice) {
    EXPECT_NEAR(restDensity(walls, lattice, point), 1.0, 0.015) << point.transpose();
  }
}

TEST(SolidDensityTest, TilesSideBySideAreOnePlate) {
  const Walls whole = withPlate(plate({0.8, 0.4, 0.05}, {0, 0, 0}));
  for (const double turn : {0.0, 90.0, 180.0}) {
    Scene scene = test::sceneOfWalls();
    scene.planes.push_back(plate({0.4, 0.4, 0.05}, {-0.2, 0, 0}));
    scene.planes.push_back(plate({0.4, 0.4, 0.05}, {0.2, 0, 0}, {0, 0, turn}));
    const Walls tiles(scene);
    for (const double x : {-0.03, 0.0, 0.02, 0.38}) {
      for (const double z : {0.025, 0.04, 0.06}) {
        EXPECT_NEAR(tiles.at({x, 0.1, z}), whole.at({x, 0.1, z}), 1e-9) << turn << " " << x;
      }
    }
  }
}

TEST(SolidDensityTest, PlatesInOnePlaceAreOnePlate) {
  const Walls one = withPlate(plate({0.4, 0.4, 0.05}, {0, 0, 0}));
  Scene scene = test::sceneOfWalls();
  for (int count = 1; count <= 6; ++count) {
    scene.planes.push_back(plate({0.4, 0.4, 0.05}, {0, 0, 0}, {0, 0, 90.0 * count}));
    const Walls all(scene);
    for (const double x : {0.0, 0.18, 0.21}) {
      EXPECT_NEAR(all.at({x, 0.1, 0.03}), one.at({x, 0.1, 0.03}), 1e-9) << count << " " << x;
    }
  }
}

TEST(SolidDensityTest, FloatAgreesWithDouble) {
  const Scene scene = crowded();
  const Walls walls(scene);
  const Colliders<float> colliders(scene, kSpacing_m / 2);
  const BoundaryDensity<float> single(
      scene, colliders, particleMass_kg(scene.fluid, kSupport_m) / scene.fluid.rest_density_kg_m3);
  for (const Vec3d& point : freePoints(walls, 500, Vec3d::Zero())) {
    EXPECT_NEAR(single.at(point.cast<float>()).value, walls.at(point), 1e-4);
  }
}

TEST(SolidDensityTest, ASceneWithoutPlatesHasNoTableOfBoxes) {
  Scene scene = test::sceneOfWalls();
  scene.containers.push_back(test::tankOf({0.8, 0.5, 0.6}, true));
  const std::size_t alone = Walls(scene).density.bytes();
  scene.planes.push_back(plate({0.2, 0.5, 0.2}, {0.3, 0, 0.2}));
  EXPECT_GT(Walls(scene).density.bytes(), alone + 100000);
}

}  // namespace solid_density_test
}  // namespace ice_ice_baby
