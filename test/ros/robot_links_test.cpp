// Colliders from the links of a robot.
#include "robot_links.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "served_scene.h"

namespace ice_ice_baby {
namespace robot_links_test {

constexpr const char* kRobot = R"(<robot name="arm">
<link name="base"/>
<link name="cup_link">
  <collision><origin xyz="0 0 0.1" rpy="0 0 1.5707963267948966"/>
    <geometry><cylinder radius="0.05" length="0.2"/></geometry></collision>
  <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
</link>
<link name="finger_left"><collision><geometry><sphere radius="0.02"/></geometry></collision></link>
<link name="finger_right"><collision><geometry>
  <mesh filename="file:///tmp/finger.stl" scale="0.001 0.001 0.001"/></geometry></collision></link>
<link name="camera"><collision><geometry>
  <mesh filename="package://arm/camera.dae" scale="0.001 -0.002 0.001"/></geometry></collision></link>
<joint name="a" type="fixed"><parent link="base"/><child link="cup_link"/></joint>
<joint name="b" type="fixed"><parent link="base"/><child link="finger_left"/></joint>
<joint name="c" type="fixed"><parent link="base"/><child link="finger_right"/></joint>
<joint name="d" type="fixed"><parent link="base"/><child link="camera"/></joint>
</robot>)";

std::string refusal(const std::string& description, const std::string& links) {
  Scene scene;
  try {
    addRobotLinks(scene, description, linkPatterns(links));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "taken";
}

class RobotLinksTest : public testing::Test {
 protected:
  void SetUp() override {
    if (refusal("", "base").find("liburdf-dev") != std::string::npos) {
      GTEST_SKIP() << "this build knows no URDF";
    }
  }
};

TEST(LinkPatternsTest, AreDividedByCommasAndSpaces) {
  EXPECT_TRUE(linkPatterns("").empty());
  EXPECT_EQ(linkPatterns("cup_link, tool0 finger_*"),
            (std::vector<std::string>{"cup_link", "tool0", "finger_*"}));
}

TEST_F(RobotLinksTest, HaveTheGeometryAndThePlaceOfTheirCollisions) {
  Scene scene;
  addRobotLinks(scene, kRobot, linkPatterns("cup_link, finger_*"));
  ASSERT_EQ(scene.cylinders.size(), 1u);
  const Cylinder& cup = scene.cylinders[0];
  EXPECT_EQ(cup.name, "cup_link");
  EXPECT_EQ(cup.follow_frame, "cup_link");
  EXPECT_EQ(cup.position_m, Vec3d(0, 0, 0.1));
  EXPECT_NEAR(cup.rpy_deg.z(), 90.0, 1e-9);
  EXPECT_EQ(cup.radius_m, 0.05);
  EXPECT_EQ(cup.height_m, 0.2);
  ASSERT_EQ(scene.boxes.size(), 1u);
  EXPECT_EQ(scene.boxes[0].name, "cup_link_2");
  EXPECT_EQ(scene.boxes[0].follow_frame, "cup_link");
  EXPECT_EQ(scene.boxes[0].size_m, Vec3d(0.1, 0.2, 0.3));
  ASSERT_EQ(scene.spheres.size(), 1u);
  EXPECT_EQ(scene.spheres[0].name, "finger_left");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].file, "/tmp/finger.stl");
  EXPECT_EQ(scene.meshes[0].scale, 0.001);
  EXPECT_EQ(scene.meshes[0].stretch, Vec3d::Ones());
}

TEST_F(RobotLinksTest, AreMirroredAndStretchedAsTheirMeshes) {
  Scene scene;
  addRobotLinks(scene, kRobot, linkPatterns("camera"));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].scale, 0.002);
  EXPECT_EQ(scene.meshes[0].stretch, Vec3d(0.5, -1, 0.5));
}

TEST_F(RobotLinksTest, AreRefusedWithTheirNames) {
  EXPECT_NE(refusal("", "cup_link").find("robot_description, which is not set"), std::string::npos);
  EXPECT_NE(refusal("<robot", "cup_link").find("is no URDF"), std::string::npos);
  const std::string unknown = refusal(kRobot, "cup_lnk");
  EXPECT_NE(unknown.find("matches cup_lnk"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("finger_left"), std::string::npos) << unknown;
  EXPECT_NE(refusal(kRobot, "base").find("link base has no collision"), std::string::npos);
}

TEST_F(RobotLinksTest, AreInEverySceneOfTheNode) {
  NodeParameters parameters;
  parameters.links = "cup_link";
  parameters.robot_description = kRobot;
  const auto file = std::filesystem::temp_directory_path() / "iib_robot_links.yaml";
  std::ofstream(file) << "blocks: [{min_m: [1, 0, 0], max_m: [1.2, 0.2, 0.2]}]\n";
  const Scene scene = loadServedScene(parameters, file.string(), "");
  EXPECT_EQ(scene.cylinders.size() + scene.boxes.size(), 2u);
  parameters.links = "";
  EXPECT_TRUE(loadServedScene(parameters, file.string(), "").cylinders.empty());
  std::filesystem::remove(file);
}

}  // namespace robot_links_test
}  // namespace ice_ice_baby
