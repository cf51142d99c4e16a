// No path passes a surface, whatever it is like.
#include "meshes/surface_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "colliders/colliders.h"
#include "ice_ice_baby/errors.h"
#include "meshes/meshes.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby {
namespace surface_contact_test {

using test::Random;

constexpr double kRadius_m = 0.006;

/// A ball of 24 long thin triangles, facing out and in at random.
TriangleMesh skinnyShell(Random& random) {
  TriangleMesh mesh = turned({{0, -0.05}, {0.05, 0.02}, {0, 0.05}}, 12);
  for (auto& t : mesh.triangles) {
    if (random.uniform(0, 1) < 0.5) std::swap(t[0], t[1]);
  }
  return mesh;
}

/// A target beyond the shell, in a third of cases through an edge or a corner.
Vec3d target(Random& random, const TriangleMesh& mesh, const Vec3d& from, int k) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(random.uniform(0, 24))];
  const Vec3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]];
  const Vec3d through = k % 6 == 0 ? a : a + random.uniform(0, 1) * (b - a);
  if (k % 3 == 0) return from + random.uniform(1, 3) * (through - from);
  return from + random.uniform(0, 0.3) * random.direction();
}

template <class Real>
class SurfaceContactTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SurfaceContactTest, Reals);

/// From inside a closed shell that turns and shakes, near the origin and 100 m from it.
TYPED_TEST(SurfaceContactTest, NothingLeavesAShellThatTumbles) {
  using Real = TypeParam;
  Random random(21);
  for (const double away : {0.0, 100.0}) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = "shell";
    mesh.position_m = Vec3d(away, -away, away);
    const TriangleMesh triangles = skinnyShell(random);
    mesh.triangles = std::make_shared<const TriangleMesh>(triangles);
    Colliders<Real> colliders(scene, kRadius_m);
    const SurfaceTree tree(triangles);
    const auto inside = [&](const Vec3d& x) { return tree.encloses(x); };
    Vec3d place = Vec3d::Zero();
    double nearest = 1.0;
    for (int k = 0; k < 20000; ++k) {
      Posed pose = colliders.pose("shell");
      const Vec3d start = pose.toWorld(place);
      const Vec3d to = pose.toWorld(target(random, triangles, place, k));
      pose.position += random.uniform(0, 0.02) * random.direction();
      pose.rotation = Eigen::AngleAxisd(random.uniform(0, 0.5), random.direction()) * pose.rotation;
      colliders.moveTo("shell", pose);
      colliders.setSubstep(0.0, 1.0);
      const Vec3<Real> end =
          colliders.respond(start.cast<Real>(), to.cast<Real>(), random.uniform(0, 1) < 0.1);
      colliders.endFrame();
      place = colliders.pose("shell").toLocal(end.template cast<double>());
      ASSERT_TRUE(inside(place)) << k << ": " << place.transpose();
      nearest = std::min(nearest, tree.closest(place, 1.0).distance_m);
    }
    const double rounding = sizeof(Real) == 4 ? 4e-6 * away : 0.0;
    EXPECT_GT(nearest, 0.15 * kRadius_m - rounding);
  }
}

/// A flat mesh stops a path as a plate does.
TEST(SurfaceContactTest2, AFlatMeshIsAPlate) {
  Random random(22);
  Scene scene;
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.triangles = std::make_shared<const TriangleMesh>(
      test::boxMesh({-0.15, -0.15, -0.05}, {0.15, 0.15, 0}, 5));
  const Colliders<double> colliders(scene, kRadius_m);
  for (int k = 0; k < 2000; ++k) {
    const Vec3d from = random.inBox({-0.1, -0.1, kRadius_m}, {0.1, 0.1, 0.05});
    const Vec3d to = from + 0.02 * random.direction();
    const Vec3d end = colliders[0].shape.resolve(from, to);
    const Vec3d plate(to.x(), to.y(), std::max(to.z(), kRadius_m));
    ASSERT_LT((end - plate).norm(), 2e-3 * kRadius_m) << k;
  }
}

/// What has no room for a particle keeps it in the middle.
TEST(SurfaceContactTest2, AGapThatIsTooNarrowKeepsWhatIsInIt) {
  Random random(23);
  for (const double gap_r : {0.5, 1.0, 1.9}) {
    TriangleMesh mesh = test::boxMesh({-0.2, -0.2, -0.05}, {0.2, 0.2, 0});
    const TriangleMesh above =
        test::boxMesh({-0.2, -0.2, gap_r * kRadius_m}, {0.2, 0.2, 0.05 + gap_r * kRadius_m});
    for (const auto& t : above.triangles) {
      const auto first = static_cast<Index>(mesh.vertices.size());
      for (const Index corner : t) mesh.vertices.push_back(above.vertices[corner]);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const Surface surface(mesh, kRadius_m);
    Vec3d x(0, 0, gap_r * kRadius_m / 2);
    for (int k = 0; k < 500; ++k) {
      x = endBeside(surface, x, x + 0.1 * random.direction());
      ASSERT_GT(x.z(), 0.0);
      ASSERT_LT(x.z(), gap_r * kRadius_m);
      x.head(2).setZero();
    }
  }
}

TEST(SurfaceContactTest2, WhatASolidLandsOnLeavesIt) {
  Random random(24);
  Scene scene;
  scene.cylinders.emplace_back().name = "post";
  const Colliders<double> colliders(scene, kRadius_m);
  const Shape<double>& post = colliders[0].shape;
  for (int k = 0; k < 1000; ++k) {
    const Vec3d x = random.inBox({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
    if (!post.solid(x)) continue;
    const Vec3d end = post.resolve(x, x);
    ASSERT_FALSE(post.solid(end));
    ASSERT_NEAR(post.near(end, 1.0).begin()->distance, kRadius_m, 1e-4 * kRadius_m);
  }
}

}  // namespace surface_contact_test
}  // namespace ice_ice_baby
