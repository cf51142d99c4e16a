// A surface answers as its tree does, with tables.
#include "meshes/surface.h"

#include <gtest/gtest.h>

#include "meshes/mesh_topology.h"
#include "meshes/meshes.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby {
namespace surface_test {

using test::Random;

/// The lattice of distances is cautious and no more than a cell off.
TEST(SurfaceTest, IsAtLeastAsFarAsItSays) {
  Random random(5);
  const double radius = 0.01;
  const Surface surface(cupMesh(0.05, 0.1, 0.002), radius);
  int near = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3d x = random.inBox({-0.1, -0.1, -0.05}, {0.1, 0.1, 0.15});
    const double distance = surface.tree().closest(x, 1.0).distance_m;
    ASSERT_LE(surface.atLeast(x), distance);
    ASSERT_LE(double(surface.atLeast<float>(x.cast<float>())), distance);
    if (distance > 4 * radius) continue;
    ++near;
    ASSERT_GT(surface.atLeast(x), distance - radius);
    ASSERT_EQ(surface.closest(x, 1.0).distance_m, distance);
    ASSERT_EQ(surface.encloses(x), surface.tree().encloses(x));
  }
  EXPECT_GT(near, 5000);
}

/// Far from the surface the tables have no distances, and know the side of whole blocks.
TEST(SurfaceTest, KnowsItsInsideFarFromTheSurface) {
  Random random(7);
  const double radius = 0.02;
  TriangleMesh two = cylinderMesh(0.2, 0.5);
  const TriangleMesh box = test::boxMesh({0.4, -0.2, -0.2}, {0.8, 0.2, 0.2});
  const auto first = static_cast<Index>(two.vertices.size());
  two.vertices.insert(two.vertices.end(), box.vertices.begin(), box.vertices.end());
  for (const auto& t : box.triangles)
    two.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  const Surface surface(welded(two), radius);
  int inside = 0, outside = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3d x = random.inBox({-0.3, -0.3, -0.4}, {1.0, 0.3, 0.4});
    if (surface.atLeast(x) < 4 * radius) continue;
    ASSERT_EQ(surface.encloses(x), surface.tree().encloses(x));
    ++(surface.encloses(x) ? inside : outside);
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 2000);
}

TEST(SurfaceTest, MeshesMadeInCodeAreCheckedToo) {
  const auto refusal = [](const std::function<void(TriangleMesh&)>& change) {
    Scene scene;
    TriangleMesh mesh = test::boxMesh(Vec3d::Zero(), Vec3d::Ones());
    change(mesh);
    scene.meshes.emplace_back().name = "cup";
    scene.meshes[0].triangles = std::make_shared<const TriangleMesh>(mesh);
    return test::refusalOf([&] { validate(scene); });
  };
  EXPECT_EQ(refusal([](TriangleMesh&) {}), "");
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(refusal([](TriangleMesh& m) { m.vertices[3].y() = std::nan(""); }), "a vertex of mesh cup");
  says(refusal([](TriangleMesh& m) { m.triangles[3][1] = 99; }), "has corner 99 of 24");
  says(refusal([](TriangleMesh& m) { m.triangles.clear(); }), "no triangle with an area");
}

TEST(SurfaceTest, ThatIsTooLargeForItsSpacingIsRefused) {
  const double size = 50.0;
  EXPECT_THROW(Surface(test::boxMesh(Vec3d::Zero(), Vec3d::Constant(size)), 0.005), InvalidInput);
  EXPECT_NO_THROW(Surface(test::boxMesh(Vec3d::Zero(), Vec3d::Constant(size)), 1.0));
}

/// Beside the surface the closest point is looked up in lists, to the same bits.
TEST(SurfaceTest, FindsTheSameClosestPointAsItsTree) {
  Random random(8);
  const double radius = 0.01;
  const Vec3d low(-0.05, -0.05, -0.03), high(0.05, 0.05, 0.12);
  const std::vector<TriangleMesh> meshes{cupMesh(0.05, 0.1, 0.002), capsuleMesh(0.03, 0.08),
                                         test::boxMesh(low, high, 20), test::boxMesh(low, high, 1),
                                         welded(test::anyTriangles(random, 40, 0.06))};
  for (const TriangleMesh& mesh : meshes) {
    const Surface surface(mesh, radius);
    int near = 0;
    for (int k = 0; k < 8000; ++k) {
      Vec3d x = random.inBox(1.5 * low, 1.5 * high);
      if (k % 4 == 0) x.x() = 0.0;  // as close to one triangle as to its mirror image
      const double reach = k % 2 == 0 ? radius : 0.5;
      const SurfacePoint found = surface.closest(x, reach),
                         wanted = surface.tree().closest(x, reach);
      ASSERT_EQ(found.triangle, wanted.triangle) << x.transpose();
      ASSERT_EQ(found.distance_m, wanted.distance_m);
      ASSERT_EQ(found.point, wanted.point);
      near += wanted.found() && wanted.distance_m < radius;
    }
    EXPECT_GT(near, 500);
  }
}

/// By what lies between a point and a place whose side is known.
TEST(SurfaceTest, KnowsItsInsideBesideTheSurface) {
  Random random(9);
  const double radius = 0.01, wall = 0.004;
  const Vec3d low(-0.05, -0.04, -0.03), high(0.05, 0.04, 0.06), thickness = Vec3d::Constant(wall);
  TriangleMesh mesh = test::boxMesh(low, high, 3);  // a hollow box
  const TriangleMesh hollow = test::boxMesh(low + thickness, high - thickness, 2);
  const auto first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), hollow.vertices.begin(), hollow.vertices.end());
  for (const auto& t : hollow.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  }
  const Surface surface(welded(mesh), radius);
  const auto within = [](const Vec3d& x, const Vec3d& from, const Vec3d& to) {
    return (x.array() > from.array()).all() && (x.array() < to.array()).all();
  };
  int inside = 0;
  for (int k = 0; k < 40000; ++k) {
    Vec3d x = random.inBox(low - thickness, high + thickness);
    if (k % 5 == 0) x.y() = 0.0;  // where triangles meet
    const bool expected = within(x, low, high) && !within(x, low + thickness, high - thickness);
    ASSERT_EQ(surface.encloses(x), expected) << x.transpose();
    inside += expected;
  }
  EXPECT_GT(inside, 5000);
}

}  // namespace surface_test
}  // namespace ice_ice_baby
