// The room around the nodes of the coarse level: sums to the space between the solids, and does not
// depend on what was computed before.
#include "coarse/free_volume.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fixtures.h"

namespace ice_ice_baby {
namespace free_volume_test {

constexpr double kSpacing_m = 0.05;

VectorField<double> cornersOf(const Vec3d& low, const Vec3d& high) {
  VectorField<double> corners;
  corners.resize(2);
  corners.set(0, low);
  corners.set(1, high);
  return corners;
}

Scene tankOnAGround() {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.containers.push_back(test::tankOf({0.6, 0.9, 1.2}, false));
  scene.planes.emplace_back();
  scene.planes[0].name = "ground";
  return scene;
}

double sumOf(const FreeVolume<double>& volume) {
  return std::accumulate(volume.atNodes().begin(), volume.atNodes().end(), 0.0);
}

TEST(FreeVolumeCoarseTest, AllNodesOfAContainerTogetherHaveItsVolume) {
  const Scene scene = tankOnAGround();
  const Colliders<double> colliders(scene, kSpacing_m / 2);
  CoarseGrids<double> grids(scene, colliders);
  grids.sort(cornersOf({-0.2, -0.3, 0.1}, {0.2, 0.3, 1.1}), colliders);
  FreeVolume<double> volume;
  volume.update(grids, colliders);
  EXPECT_NEAR(sumOf(volume) * std::pow(kSpacing_m, 3), 0.6 * 0.9 * 1.2, 1e-9);
}

TEST(FreeVolumeCoarseTest, ASphereInAContainerTakesItsVolume) {
  Scene scene = tankOnAGround();
  scene.spheres.emplace_back();
  scene.spheres[0].name = "ball";
  scene.spheres[0].radius_m = 0.2;
  scene.spheres[0].position_m = {0.02, -0.05, 0.6};
  const Colliders<double> colliders(scene, kSpacing_m / 2);
  CoarseGrids<double> grids(scene, colliders);
  grids.sort(cornersOf({-0.2, -0.3, 0.1}, {0.2, 0.3, 1.1}), colliders);
  FreeVolume<double> volume;
  volume.update(grids, colliders);
  const double ball_m3 = 4 * M_PI / 3 * std::pow(0.2, 3);
  EXPECT_NEAR(0.6 * 0.9 * 1.2 - sumOf(volume) * std::pow(kSpacing_m, 3), ball_m3, 0.05 * ball_m3);
}

TEST(FreeVolumeCoarseTest, ABoxThatGrowsOrShrinksHasTheBitsOfANewOne) {
  const Scene scene = tankOnAGround();
  const Colliders<double> colliders(scene, kSpacing_m / 2);
  CoarseGrids<double> grids(scene, colliders);
  FreeVolume<double> followed;
  // Beside the tank, on the ground: every box of the world's grid cuts the wall of the tank.
  for (const Vec3d& reach : {Vec3d(1, 1, 1), Vec3d(3, 1, 1.5), Vec3d(2, 4, 0.5), Vec3d(5, 5, 3)}) {
    grids.sort(cornersOf(-reach.cwiseProduct(Vec3d(1, 1, 0)), reach), colliders);
    followed.update(grids, colliders);
    FreeVolume<double> fresh;
    fresh.update(grids, colliders);
    ASSERT_EQ(followed.atNodes(), fresh.atNodes());
    EXPECT_GT(sumOf(fresh), 0.0);
  }
}

TEST(FreeVolumeCoarseTest, AMovedColliderIsFollowed) {
  Scene scene = tankOnAGround();
  scene.spheres.emplace_back();
  scene.spheres[0].name = "ball";
  scene.spheres[0].radius_m = 0.2;
  scene.spheres[0].position_m = {0, 0, 0.6};
  Colliders<double> colliders(scene, kSpacing_m / 2);
  CoarseGrids<double> grids(scene, colliders);
  FreeVolume<double> followed;
  for (const double x : {0.0, 0.05, 0.05, 2.0}) {
    Posed pose = Posed();
    pose.position = {x, 0, 0.6};
    colliders.moveTo("ball", pose);
    colliders.endFrame();
    colliders.setSubstep(1, 1);
    grids.sort(cornersOf({-0.2, -0.3, 0.1}, {0.2, 0.3, 1.1}), colliders);
    followed.update(grids, colliders);
    FreeVolume<double> fresh;
    fresh.update(grids, colliders);
    EXPECT_EQ(followed.atNodes(), fresh.atNodes()) << x;
  }
  EXPECT_NEAR(sumOf(followed) * std::pow(kSpacing_m, 3), 0.6 * 0.9 * 1.2, 1e-9);
}

}  // namespace free_volume_test
}  // namespace ice_ice_baby
