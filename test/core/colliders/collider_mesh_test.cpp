// Surfaces of colliders as triangles: whole, the right way out and where the shape is.
#include "ice_ice_baby/collider_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "colliders/shape.h"
#include "fixtures.h"

namespace ice_ice_baby {
namespace collider_mesh_test {

/// By the divergence theorem; negative when the triangles face inwards.
double volume(const ColliderMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  }
  return sum;
}

double area(const ColliderMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3d& a = mesh.vertices[t[0]];
    sum += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  return sum;
}

/// Every edge of a triangle is passed once each way.
void expectClosed(const ColliderMesh& mesh) {
  std::map<std::pair<Index, Index>, int> passed;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++passed[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, times] : passed) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(passed.count({edge.second, edge.first}), 1u);
  }
}

Plane plateOf(double x, double y, double thickness) {
  Plane plane;
  plane.size_x_m = x;
  plane.size_y_m = y;
  plane.thickness_m = thickness;
  return plane;
}

struct Case {
  Collider collider;
  ColliderMesh mesh;
};

std::vector<Case> meshesOf(const Scene& scene, const MeshDetail& detail = {}) {
  std::vector<Case> cases;
  forEachColliderMesh(scene, detail, [&](const Collider& c, const ColliderMesh& mesh) {
    cases.push_back({c, mesh});
  });
  return cases;
}

Scene everyShape() {
  Scene scene;
  scene.containers = {test::tankOf({0.8, 0.5, 0.6}, true, "open"),
                      test::tankOf({0.8, 0.5, 0.6}, false, "closed")};
  scene.planes = {Plane(), plateOf(0.6, 0.4, 0.05)};
  scene.planes[0].name = "ground";
  scene.planes[1].name = "plate";
  scene.spheres.emplace_back().radius_m = 0.3;
  scene.spheres[0].name = "ball";
  scene.boxes.emplace_back().size_m = {0.5, 0.3, 0.4};
  scene.boxes[0].name = "box";
  return scene;
}

TEST(ColliderMeshTest, IsClosedAndComesInTheOrderOfTheScene) {
  const std::vector<Case> cases = meshesOf(everyShape());
  const std::array<std::string, 6> names{"open", "closed", "ground", "plate", "ball", "box"};
  ASSERT_EQ(cases.size(), names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    SCOPED_TRACE(names[k]);
    EXPECT_EQ(cases[k].collider.name, names[k]);
    EXPECT_EQ(cases[k].mesh.infinite, names[k] == "ground");
    expectClosed(cases[k].mesh);
  }
}

TEST(ColliderMeshTest, FacesOutwardsAndHoldsTheVolumeOfTheSolid) {
  const Scene scene = everyShape();
  const std::vector<Case> cases = meshesOf(scene);
  const double w = scene.containers[0].wall_m;
  const double hollow = 0.8 * 0.5 * 0.6, sides = (0.8 + 2 * w) * (0.5 + 2 * w);
  EXPECT_NEAR(volume(cases[0].mesh), sides * (0.6 + w) - hollow, 1e-12);
  EXPECT_NEAR(volume(cases[1].mesh), sides * (0.6 + 2 * w) - hollow, 1e-12);
  EXPECT_NEAR(volume(cases[2].mesh), 20.0 * 20.0 * 0.01, 1e-9);
  EXPECT_NEAR(volume(cases[3].mesh), 0.6 * 0.4 * 0.05, 1e-12);
  EXPECT_NEAR(area(cases[3].mesh), 2 * (0.6 * 0.4 + 0.6 * 0.05 + 0.4 * 0.05), 1e-12);
  EXPECT_NEAR(volume(cases[5].mesh), 0.5 * 0.3 * 0.4, 1e-12);
  EXPECT_NEAR(area(cases[5].mesh), 2 * (0.5 * 0.3 + 0.5 * 0.4 + 0.3 * 0.4), 1e-12);
}

TEST(ColliderMeshTest, OfABallComesNearerToItWithMoreSegments) {
  Scene scene;
  scene.spheres.emplace_back().radius_m = 0.3;
  const double exact = 4 * M_PI * std::pow(0.3, 3) / 3, surface = 4 * M_PI * 0.09;
  double before = 2.0;
  for (const std::size_t segments : {4u, 8u, 32u, 128u}) {
    MeshDetail detail;
    detail.round_segments = segments;
    const ColliderMesh mesh = meshesOf(scene, detail)[0].mesh;
    expectClosed(mesh);
    const double lacking = 1 - volume(mesh) / exact;
    EXPECT_GT(lacking, 0.0);
    EXPECT_LT(lacking, before / 2);
    EXPECT_LT(area(mesh), surface);
    before = lacking;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(ColliderMeshTest, VerticesLieOnTheSurface) {
  const Scene scene = everyShape();
  const std::vector<Case> cases = meshesOf(scene);
  const double w = scene.containers[0].wall_m;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Vec3d& v : cases[k].mesh.vertices) {
      const bool inner = std::abs(v.x()) < 0.41;
      EXPECT_NEAR(std::abs(v.x()), inner ? 0.4 : 0.4 + w, 1e-12);
      EXPECT_NEAR(std::abs(v.y()), inner ? 0.25 : 0.25 + w, 1e-12);
      const double top = inner || k == 0 ? 0.6 : 0.6 + w;
      EXPECT_NEAR(v.z(), v.z() > 0.3 ? top : inner ? 0.0 : -w, 1e-12);
    }
  }
  for (const Vec3d& v : cases[3].mesh.vertices) {
    EXPECT_LT((v.cwiseAbs().head(2) - Vec3d(0.3, 0.2, 0).head(2)).norm(), 1e-12);
    EXPECT_NEAR(v.z(), v.z() > -0.02 ? 0.0 : -0.05, 1e-12);
  }
  for (const Vec3d& v : cases[4].mesh.vertices) EXPECT_NEAR(v.norm(), 0.3, 1e-12);
  for (const Vec3d& v : cases[5].mesh.vertices) {
    EXPECT_LT((v.cwiseAbs() - Vec3d(0.25, 0.15, 0.2)).norm(), 1e-12);
  }
  EXPECT_EQ(cases[4].mesh.half_axes_m, Vec3d::Constant(0.3));
}

TEST(ColliderMeshTest, EdgesOfABoxAreThoseOfItsInside) {
  for (const Case& one : meshesOf(everyShape())) {
    const bool glass = one.mesh.look == Look::kGlass;
    ASSERT_EQ(one.mesh.edges.size(), glass ? 12u : 0u) << one.collider.name;
    for (const auto& [a, b] : one.mesh.edges) {
      const Vec3d along = one.mesh.vertices[b] - one.mesh.vertices[a];
      EXPECT_EQ((along.array() != 0).count(), 1);
      EXPECT_NEAR(std::abs(one.mesh.vertices[a].x()), 0.4, 1e-12);
    }
  }
}

/// A shape that bounds centres of particles is drawn grown by their radius.
TEST(ColliderMeshTest, OfAGrownShapeBoundsCentres) {
  Scene scene = everyShape();
  const auto grown = makeShape<double>(scene.spheres[0], 0.02).mesh({});
  EXPECT_EQ(grown.half_axes_m, Vec3d::Constant(0.32));
  const auto plate = makeShape<double>(scene.planes[1], 0.02).mesh({});
  EXPECT_NEAR(volume(plate), 0.64 * 0.44 * 0.09, 1e-12);
}

}  // namespace collider_mesh_test
}  // namespace ice_ice_baby
