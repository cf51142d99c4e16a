// Cameras of a scene: their poses, their names, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {
namespace cameras_test {

Camera camera(const Vec3d& position_m, const Vec3d& look_at_m) {
  Camera made;
  made.position_m = position_m;
  made.look_at_m = look_at_m;
  return made;
}

TEST(CameraParams, LookAtTheirPointUprightFromAllAround) {
  const Vec3d target(1, -2, 0.5);
  for (double azimuth = 0.1; azimuth < 6.3; azimuth += 0.7) {
    for (double height = -3; height <= 3; height += 0.5) {
      const Vec3d from = target + Vec3d(2 * std::cos(azimuth), 2 * std::sin(azimuth), height);
      const Posed pose = camera(from, target).pose();
      const Vec3d right = pose.rotation.col(0), down = pose.rotation.col(1),
                  ahead = pose.rotation.col(2);
      EXPECT_LT((pose.rotation.transpose() * pose.rotation - Mat3<double>::Identity()).norm(),
                1e-12);
      EXPECT_NEAR(pose.rotation.determinant(), 1.0, 1e-12);
      EXPECT_LT((ahead - (target - from).normalized()).norm(), 1e-12);
      EXPECT_NEAR(right.z(), 0.0, 1e-12);
      EXPECT_LT(down.z(), 0.0);
    }
  }
}

TEST(CameraParams, LookStraightDownAndUp) {
  for (const double way : {-1.0, 1.0}) {
    const Posed pose = camera(Vec3d::Zero(), {0, 0, way}).pose();
    EXPECT_EQ(pose.rotation.col(0), Vec3d::UnitX());
    EXPECT_EQ(pose.rotation.col(2), Vec3d(0, 0, way));
    EXPECT_NEAR(pose.rotation.determinant(), 1.0, 1e-12);
  }
}

TEST(CameraParams, HaveTheirAngleAcrossTheWidth) {
  Camera wide;
  wide.width = 200;
  wide.fov_deg = 90;
  EXPECT_NEAR(wide.focalLength(), 100, 1e-9);
}

std::string refusal(const std::string& cameras, const std::string& more = "") {
  return test::refusalOf([&] { parseScene("cameras: " + cameras + "\n" + more, {}, "scene"); });
}

TEST(CameraParams, AreNamedAndRefusedByKey) {
  const Scene scene = parseScene("cameras: [{}, {name: wrist, follow_frame: tool0}]");
  EXPECT_EQ(scene.cameras.at(0).name, "camera_0");
  EXPECT_EQ(scene.cameras.at(1).follow_frame, "tool0");
  EXPECT_NE(refusal("[{position_m: [1, 1, 1], look_at_m: [1, 1, 1]}]").find("cameras.0.look_at_m"),
            std::string::npos);
  EXPECT_EQ(refusal("[{follow_frame: a, position_m: [1, 1, 1], look_at_m: [1, 1, 1]}]"), "");
  EXPECT_NE(refusal("[{name: a}, {name: a}]").find("cameras.1.name = a"), std::string::npos);
  EXPECT_NE(refusal("[{name: tub}]", "containers: [{name: tub}]").find("of a collider"),
            std::string::npos);
  EXPECT_NE(refusal("[{width: 5}]").find("cameras.0.width = 5"), std::string::npos);
  EXPECT_NE(refusal("[{fov: 5}]").find("did you mean cameras.0.fov_deg"), std::string::npos);
  EXPECT_NE(refusal("[{}, {}, {}, {}, {}, {}, {}, {}, {}]").find("at most 8"), std::string::npos);
  EXPECT_NE(refusal("[{follow_frame: 'a b'}]").find("follow_frame of camera"), std::string::npos);
}

TEST(CameraParams, DoNotChangeTheWater) {
  const std::string scene = "blocks: [{min_m: [0, 0, 0], max_m: [0.2, 0.2, 0.2]}]\n";
  const auto heightsAfter = [](const std::string& text) {
    const auto simulation = makeSimulation(parseScene(text));
    for (int frame = 0; frame < 3; ++frame) simulation->advanceFrame();
    std::vector<ParticleSample> samples;
    simulation->sample(samples, 1);
    std::vector<float> heights_m;
    for (const ParticleSample& sample : samples) heights_m.push_back(sample.z);
    return heights_m;
  };
  EXPECT_EQ(heightsAfter(scene), heightsAfter(scene + "cameras: [{}]"));
}

}  // namespace cameras_test
}  // namespace ice_ice_baby
