// Which particles are drawn as water, ice and steam.
#include "phase_points.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

namespace ice_ice_baby {
namespace {

using sensor_msgs::PointField;

/// Points of x, y, z, ice_fraction, density and rgb, as the node's but for what is not drawn.
class Cloud {
 public:
  Cloud() {
    for (const char* name : {"x", "y", "z", "ice_fraction", "density", "rgb"}) {
      PointField field;
      field.name = name;
      field.offset = message.point_step;
      field.datatype = PointField::FLOAT32;
      field.count = 1;
      message.fields.push_back(field);
      message.point_step += 4;
    }
    message.height = 1;
  }

  void add(float x, float ice, float density) {
    const float values[] = {x, 2.0F, 3.0F, ice, density, 0.0F};
    const std::size_t at = message.data.size();
    message.data.resize(at + sizeof values);
    std::memcpy(&message.data[at], values, sizeof values);
    const std::uint32_t colour = 0xFF8000;
    std::memcpy(&message.data[at + 20], &colour, sizeof colour);
    ++message.width;
  }

  sensor_msgs::PointCloud2 message;
};

TEST(PhasePointsTest, WaterIceAndSteamPart) {
  Cloud cloud;
  cloud.add(1.0F, 0.0F, 1.0F);
  cloud.add(2.0F, 0.3F, 1.0F);
  cloud.add(3.0F, 0.7F, 0.95F);
  cloud.add(4.0F, 1.0F, 0.92F);
  cloud.add(5.0F, 0.0F, 0.0F);
  PhasePoints points;
  splitPhases(cloud.message, points);
  ASSERT_EQ(points.of[WATER].size(), 2U);
  ASSERT_EQ(points.of[ICE].size(), 2U);
  ASSERT_EQ(points.of[STEAM].size(), 1U);
  EXPECT_EQ(points.freezing, 0.0F);
  EXPECT_EQ(points.of[ICE][1].position.x, 4.0F);
  EXPECT_EQ(points.of[STEAM][0].position.z, 3.0F);
  EXPECT_EQ(points.of[WATER][0].color.r, 1.0F);
  EXPECT_NEAR(points.of[WATER][0].color.g, 0.5, 0.01);
  EXPECT_EQ(points.of[WATER][0].color.b, 0.0F);
}

TEST(PhasePointsTest, AllOfOneShareOfIceStaysTogether) {
  for (const float share : {0.0F, 0.4F, 0.8F, 1.0F}) {
    Cloud cloud;
    cloud.add(1.0F, share, 1.0F);
    cloud.add(2.0F, share, 0.9F);
    cloud.add(3.0F, 0.0F, 0.0F);  // steam does not count
    PhasePoints points;
    splitPhases(cloud.message, points);
    EXPECT_EQ(points.of[WATER].size(), 2U);
    EXPECT_EQ(points.freezing, share);
    EXPECT_EQ(points.of[STEAM].size(), 1U);
  }
}

TEST(PhasePointsTest, NothingIsLeftOfTheCloudBefore) {
  Cloud cloud;
  cloud.add(1.0F, 0.0F, 1.0F);
  cloud.add(1.0F, 1.0F, 1.0F);
  PhasePoints points;
  splitPhases(cloud.message, points);
  splitPhases(Cloud().message, points);
  for (const auto& of_phase : points.of) EXPECT_TRUE(of_phase.empty());
}

TEST(PhasePointsTest, PlainCloudIsWater) {
  Cloud cloud;
  cloud.add(1.0F, 1.0F, 0.0F);
  cloud.message.fields.resize(3);
  PhasePoints points;
  splitPhases(cloud.message, points);
  ASSERT_EQ(points.of[WATER].size(), 1U);
  EXPECT_EQ(points.freezing, 0.0F);
  EXPECT_GT(points.of[WATER][0].color.b, 0.5F);
}

TEST(PhasePointsTest, BrokenCloudsAreRefused) {
  PhasePoints points;
  Cloud short_of_bytes;
  short_of_bytes.add(1.0F, 1.0F, 0.0F);
  short_of_bytes.message.width = 2;
  EXPECT_THROW(splitPhases(short_of_bytes.message, points), std::invalid_argument);
  Cloud beyond;
  beyond.add(1.0F, 0.0F, 1.0F);
  beyond.message.fields[0].offset = 22;
  EXPECT_THROW(splitPhases(beyond.message, points), std::invalid_argument);
  EXPECT_THROW(splitPhases(sensor_msgs::PointCloud2(), points), std::invalid_argument);
}

}  // namespace
}  // namespace ice_ice_baby
