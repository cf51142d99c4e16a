// Depth and labels of shapes whose picture geometry gives.
#include "ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fluid_surface.h"

namespace ice_ice_baby {
namespace {

using Vertices = std::vector<Vec3<float>>;
using Triangles = std::vector<std::array<Index, 3>>;

/// A square about a point, level, of two triangles.
void addSquare(RayScene& scene, const Vec3<float>& centre, float half_m, Seen seen) {
  Vertices corners;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    corners.push_back(centre + half_m * Vec3<float>(float(x), float(y), 0));
  }
  scene.add(corners, Triangles{{0, 1, 2}, {0, 2, 3}}, seen);
}

/// A ball of latitudes and longitudes, finer than a pixel.
void addBall(RayScene& scene, const Vec3<float>& centre, float radius_m, Seen seen) {
  constexpr Index kRings = 200, kSides = 400;
  Vertices vertices;
  Triangles triangles;
  for (Index r = 0; r <= kRings; ++r) {
    for (Index s = 0; s < kSides; ++s) {
      const double polar = M_PI * r / kRings, round = 2 * M_PI * s / kSides;
      vertices.push_back(centre + radius_m * Vec3<float>(float(std::sin(polar) * std::cos(round)),
                                                         float(std::sin(polar) * std::sin(round)),
                                                         float(std::cos(polar))));
      const Index next = (s + 1) % kSides;
      if (r == kRings) continue;
      triangles.push_back({r * kSides + s, (r + 1) * kSides + s, r * kSides + next});
      triangles.push_back({r * kSides + next, (r + 1) * kSides + s, (r + 1) * kSides + next});
    }
  }
  scene.add(vertices, triangles, seen);
}

Camera cameraAt(const Vec3d& position_m, const Vec3d& look_at_m) {
  Camera camera;
  camera.position_m = position_m;
  camera.look_at_m = look_at_m;
  return camera;
}

class RaySceneTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!castsRays()) GTEST_SKIP() << "built without Embree";
  }
};

std::size_t at(const CameraPicture& picture, int x, int y) {
  return std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
}

TEST_F(RaySceneTest, ALevelPlaneFromAboveHasOneDepth) {
  for (const double scale : {0.01, 1.0, 100.0}) {
    RayScene scene;
    addSquare(scene, Vec3<float>::Zero(), float(10 * scale), Seen::kWater);
    Camera camera = cameraAt({0, 0, scale}, Vec3d::Zero());
    camera.range_m = 1000;
    const CameraPicture picture = scene.picture(camera, camera.pose());
    ASSERT_EQ(picture.depth_m.size(), 640u * 480u);
    for (const float depth_m : picture.depth_m) ASSERT_NEAR(depth_m, scale, 1e-5 * scale);
    for (const Seen seen : picture.seen) ASSERT_EQ(seen, Seen::kWater);
  }
}

TEST_F(RaySceneTest, ATiltedPlaneHasTheDepthOfEachPixel) {
  RayScene scene;
  addSquare(scene, Vec3<float>::Zero(), 50, Seen::kSolid);
  for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
    const Vec3d from(std::cos(azimuth), std::sin(azimuth), 0.8);
    Camera camera = cameraAt(from, Vec3d::Zero());
    camera.width = 101;  // no whole number of packets
    camera.height = 75;
    camera.range_m = 30;
    const CameraPicture picture = scene.picture(camera, camera.pose());
    const Posed pose = camera.pose();
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const double f = camera.focalLength();
        const Vec3d ray = pose.rotation * Vec3d((x + 0.5 - 50.5) / f, (y + 0.5 - 37.5) / f, 1);
        const float depth_m = picture.depth_m[at(picture, x, y)];
        const double expected = from.z() / -ray.z();
        if (ray.z() < 0 && expected < 0.999 * camera.range_m) {
          ASSERT_NEAR(depth_m, expected, 1e-4 * expected) << x << " " << y;
        } else if (ray.z() >= 0 || expected > 1.001 * camera.range_m) {
          ASSERT_TRUE(std::isnan(depth_m)) << x << " " << y;
        }
      }
    }
  }
}

TEST_F(RaySceneTest, ABallIsADiscOfTheRightSizeAndDepth) {
  const double radius_m = 0.25, distance_m = 2.0;
  RayScene scene;
  addBall(scene, {0, 0, 0}, float(radius_m), Seen::kIce);
  const Camera camera = cameraAt({0, -distance_m, 0}, Vec3d::Zero());
  const CameraPicture picture = scene.picture(camera, camera.pose());
  EXPECT_NEAR(picture.depth_m[at(picture, 320, 240)], distance_m - radius_m, 1e-4);
  const auto pixels = double(std::count(picture.seen.begin(), picture.seen.end(), Seen::kIce));
  // The outline is where rays touch the ball: a cone of half the angle asin(r / distance).
  const double half = camera.focalLength() * std::tan(std::asin(radius_m / distance_m));
  EXPECT_NEAR(pixels, M_PI * half * half, 0.005 * pixels);
  EXPECT_EQ(picture.seen[at(picture, 0, 0)], Seen::kNothing);
  EXPECT_TRUE(std::isnan(picture.depth_m[at(picture, 0, 0)]));
}

TEST_F(RaySceneTest, WhatIsNearerCoversWhatIsBehind) {
  RayScene scene;
  addSquare(scene, {0, 0, 0}, 1, Seen::kSolid);
  addSquare(scene, {0.5f, 0, 0.2f}, 0.5f, Seen::kWater);
  const Camera camera = cameraAt({0, 0, 2}, Vec3d::Zero());
  const CameraPicture picture = scene.picture(camera, camera.pose());
  EXPECT_EQ(picture.seen[at(picture, 400, 240)], Seen::kWater);  // x to the right
  EXPECT_EQ(picture.seen[at(picture, 240, 240)], Seen::kSolid);
  EXPECT_NEAR(picture.depth_m[at(picture, 400, 240)], 1.8, 1e-5);
  EXPECT_NEAR(picture.depth_m[at(picture, 240, 240)], 2.0, 1e-5);
}

TEST_F(RaySceneTest, UpIsUpInThePicture) {
  RayScene scene;
  addBall(scene, {0, 0, 0.4f}, 0.1f, Seen::kIce);
  for (const Vec3d& from : {Vec3d(2, 0, 0), Vec3d(0, 2, 0), Vec3d(-2, -1, 0.5)}) {
    const Camera camera = cameraAt(from, Vec3d::Zero());
    const CameraPicture picture = scene.picture(camera, camera.pose());
    const auto middle = picture.seen.begin() + long(picture.seen.size() / 2);
    EXPECT_GT(std::count(picture.seen.begin(), middle, Seen::kIce), 1000);
    EXPECT_EQ(std::count(middle, picture.seen.end(), Seen::kIce), 0);
  }
}

TEST_F(RaySceneTest, NothingIsSeenInAnEmptyScene) {
  RayScene scene;
  scene.add({}, {}, Seen::kWater);
  const CameraPicture picture = scene.picture(Camera(), Camera().pose());
  for (const Seen seen : picture.seen) ASSERT_EQ(seen, Seen::kNothing);
}

TEST_F(RaySceneTest, ASurfaceOfAPoolIsSeenHalfASpacingAboveItsTopLayer) {
  if (!makesSurfaces()) GTEST_SKIP() << "built without OpenVDB";
  const float d = 0.02f;
  std::vector<ParticleSample> pool;
  for (int k = 0; k < 40 * 40 * 8; ++k) {
    ParticleSample p{};
    p.x = d * float(k % 40 - 20);
    p.y = d * float(k / 40 % 40 - 20);
    p.z = d * (0.5f + float(k / 1600));
    pool.push_back(p);
  }
  const FluidSurface surface = surfaceOf(pool, Phase::kWater, double(d), SurfaceValues::kShapeOnly);
  RayScene scene;
  scene.add(surface.vertices, surface.triangles, Seen::kWater);
  Camera camera = cameraAt({0, 0, 0.66}, Vec3d::Zero());
  camera.fov_deg = 40;
  const CameraPicture picture = scene.picture(camera, camera.pose());
  for (const float depth_m : picture.depth_m) ASSERT_NEAR(depth_m, 0.66 - 8 * d, 0.1 * d);
}

}  // namespace
}  // namespace ice_ice_baby
