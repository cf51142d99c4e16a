// Closest points and rays, against every triangle in turn.
#include "meshes/surface_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/mesh_curvature.h"
#include "meshes/mesh_topology.h"
#include "meshes/meshes.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby {
namespace surface_tree_test {

using test::Random;

TEST(TriangleTest, TheClosestPointIsTheBestOfManyPoints) {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const Vec3d low = Vec3d::Constant(-1), high = Vec3d::Ones();
    const Triangle t{random.inBox(low, high), random.inBox(low, high), random.inBox(low, high)};
    const Vec3d x = 2 * random.inBox(low, high);
    const double closest = (closestPoint(t, x).point - x).norm();
    double sampled = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100; ++i) {
      for (int j = 0; i + j <= 100; ++j) {
        const Vec3d point = t.a + (t.b - t.a) * i / 100 + (t.c - t.a) * j / 100;
        sampled = std::min(sampled, (point - x).norm());
      }
    }
    ASSERT_LE(closest, sampled + 1e-12);
    ASSERT_GT(closest, sampled - 0.03);
  }
}

TEST(SurfaceTreeTest, FindsTheClosestOfAllTriangles) {
  Random random(2);
  for (const int count : {1, 3, 50, 1000}) {
    const SurfaceTree tree(test::anyTriangles(random, count, 1.0));
    for (int k = 0; k < 300; ++k) {
      const Vec3d x = random.inBox(Vec3d::Constant(-2), Vec3d::Constant(2));
      double best = std::numeric_limits<double>::infinity();
      for (Index t = 0; t < tree.count(); ++t) {
        best = std::min(best, (closestPoint(tree.triangle(t), x).point - x).norm());
      }
      const Index hint = static_cast<Index>(k) % static_cast<Index>(count);
      const SurfacePoint near = tree.closest(x, 10.0), hinted = tree.closest(x, 10.0, hint);
      ASSERT_NEAR(near.distance_m, best, 1e-14);
      ASSERT_EQ(near.triangle, hinted.triangle);
      ASSERT_EQ(near.point, hinted.point);
      ASSERT_FALSE(tree.closest(x, 0.99 * best).found());
    }
  }
}

TEST(SurfaceTreeTest, FindsTheFirstTriangleOnARay) {
  Random random(3);
  const SurfaceTree tree(test::anyTriangles(random, 300, 1.0));
  int met = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vec3d origin = 2 * random.inBox(-Vec3d::Ones(), Vec3d::Ones());
    const Vec3d way = k % 10 == 0 ? Vec3d(Vec3d::Unit(k % 3)) : random.direction();
    double best = std::numeric_limits<double>::infinity();
    for (Index t = 0; t < tree.count(); ++t) {
      const auto distance = hit(tree.triangle(t), origin, way);
      if (distance && *distance > 0) best = std::min(best, *distance);
    }
    ASSERT_EQ(tree.firstHit(origin, way, 0.0, 100.0), best);
    if (!std::isfinite(best)) continue;
    ++met;
    ASSERT_TRUE(tree.crosses(origin, origin + 1.001 * best * way));
    ASSERT_FALSE(tree.crosses(origin, origin + 0.999 * best * way));
  }
  EXPECT_GT(met, 150);
}

/// Rays along the sides of a box meet edges and corners.
TEST(SurfaceTreeTest, EnclosesWhatLiesInABoxAndNothingElse) {
  Random random(4);
  const Vec3d low(-0.3, -0.2, -0.1), high(0.2, 0.4, 0.5);
  const SurfaceTree tree(test::boxMesh(low, high, 3));
  for (int k = 0; k < 20000; ++k) {
    const Vec3d x = random.inBox(Vec3d::Constant(-0.6), Vec3d::Constant(0.6));
    const bool inside = (x.array() > low.array()).all() && (x.array() < high.array()).all();
    ASSERT_EQ(tree.encloses(x), inside) << x.transpose();
  }
  EXPECT_TRUE(tree.encloses((low + high) / 2));
}

TEST(MeshTopologyTest, TellsClosedFromOpen) {
  const TriangleMesh whole = welded(test::boxMesh(-Vec3d::Ones(), Vec3d::Ones(), 2));
  EXPECT_TRUE(topologyOf(whole).closed());
  EXPECT_NEAR(topologyOf(whole).volume_m3, 8.0, 1e-12);
  TriangleMesh lacking = whole;
  lacking.triangles.pop_back();
  EXPECT_EQ(topologyOf(lacking).open_edges, 3u);
  TriangleMesh turned = whole;
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_EQ(topologyOf(turned).mixed_edges, 3u);
}

TEST(SolidsOfRevolutionTest, AreClosedAndAsLargeAsTheRoundOnes) {
  const double r = 0.05, h = 0.12, wall = 0.004;
  const auto volume = [](const TriangleMesh& mesh) {
    EXPECT_TRUE(topologyOf(mesh).closed());
    return topologyOf(mesh).volume_m3;
  };
  EXPECT_NEAR(volume(cylinderMesh(r, h)), M_PI * r * r * h, 1e-12);
  EXPECT_NEAR(volume(capsuleMesh(r, h)) / (M_PI * r * r * (h + 4 * r / 3)), 1.0, 2e-3);
  const double outer = r + wall;
  EXPECT_NEAR(volume(cupMesh(r, h, wall)), M_PI * (outer * outer * (h + wall) - r * r * h), 1e-12);
}

TEST(MeshCurvatureTest, IsThatOfTheRoundSurface) {
  const double r = 0.05;
  const auto range = [](const TriangleMesh& mesh, auto counts) {
    const std::vector<double> bending = bendingOf(mesh);
    Eigen::AlignedBox<double, 1> found;
    for (Index k = 0; k < mesh.triangles.size(); ++k) {
      const auto& t = mesh.triangles[k];
      const Vec3d centre = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
      if (counts(centre)) found.extend(Eigen::Matrix<double, 1, 1>(bending[k]));
    }
    return std::pair(found.min()[0] * 0.05, found.max()[0] * 0.05);
  };
  const auto side =
      range(cylinderMesh(r, 0.2), [&](const Vec3d& x) { return x.head(2).norm() > 0.9 * r; });
  EXPECT_NEAR(side.first, 1.0, 0.01);
  EXPECT_NEAR(side.second, 1.0, 0.01);
  const auto lid =
      range(cylinderMesh(r, 0.2), [&](const Vec3d& x) { return std::abs(x.z()) > 0.099; });
  EXPECT_EQ(lid.second, 0.0);
  const auto inside = range(cupMesh(r, 0.2, 0.02), [&](const Vec3d& x) {
    return x.head(2).norm() > 0.9 * r && x.head(2).norm() < 1.05 * r && x.z() < 0.19 &&
           x.z() > 0.01;
  });
  EXPECT_NEAR(inside.first, -1.0, 0.01);
  EXPECT_NEAR(inside.second, -1.0, 0.01);
}

}  // namespace surface_tree_test
}  // namespace ice_ice_baby
