// Which particles are drawn as water, ice and steam.
#include "phase_points.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

namespace ice_ice_baby {
namespace {

using sensor_msgs::PointField;

/// Points of x, y, z, ice_fraction, density, phase and rgb, as the node's but for what is not
/// drawn.
class Cloud {
 public:
  Cloud() {
    for (const char* name : {"x", "y", "z", "ice_fraction", "density", "phase", "rgb"}) {
      PointField field;
      field.name = name;
      field.offset = message.point_step;
      field.datatype = field.name == "phase" ? PointField::UINT8 : PointField::FLOAT32;
      field.count = 1;
      message.fields.push_back(field);
      message.point_step += 4;
    }
    message.height = 1;
  }

  void add(float x, float ice, Phase phase, float density = 1.0F) {
    const float values[] = {x, 2.0F, 3.0F, ice, density, 0.0F, 0.0F};
    const std::size_t at = message.data.size();
    message.data.resize(at + sizeof values);
    std::memcpy(&message.data[at], values, sizeof values);
    message.data[at + PHASE_AT] = static_cast<std::uint8_t>(phase);
    const std::uint32_t colour = 0xFF8000;
    std::memcpy(&message.data[at + 24], &colour, sizeof colour);
    ++message.width;
  }

  /// As a cloud of a node that did not tell the phase.
  void removePhase() { message.fields.erase(message.fields.begin() + 5); }

  static constexpr std::size_t PHASE_AT = 20;

  sensor_msgs::PointCloud2 message;
};

std::size_t countOf(const PhasePoints& points, Phase phase) {
  return points.of[indexOf(phase)].size();
}

TEST(PhasePointsTest, WaterIceAndSteamPartByTheirPhaseAlone) {
  Cloud cloud;
  cloud.add(1.0F, 0.0F, Phase::kWater);
  cloud.add(2.0F, 0.6F, Phase::kWater);  // slush that flows
  cloud.add(3.0F, 0.4F, Phase::kIce);    // ice that melts
  cloud.add(4.0F, 1.0F, Phase::kIce);
  cloud.add(5.0F, 0.0F, Phase::kSteam);
  cloud.add(6.0F, 0.0F, Phase::kWater, 0.0F);  // a lone drop
  PhasePoints points;
  splitPhases(cloud.message, points);
  ASSERT_EQ(countOf(points, Phase::kWater), 3U);
  ASSERT_EQ(countOf(points, Phase::kIce), 2U);
  ASSERT_EQ(countOf(points, Phase::kSteam), 1U);
  EXPECT_TRUE(points.has_phases);
  EXPECT_EQ(points.freezing, 0.0F);
  EXPECT_EQ(points.of[indexOf(Phase::kIce)][1].position.x, 4.0F);
  EXPECT_EQ(points.of[indexOf(Phase::kSteam)][0].position.z, 3.0F);
  const auto& water = points.of[indexOf(Phase::kWater)];
  EXPECT_EQ(water[1].position.x, 2.0F);
  EXPECT_EQ(water[0].color.r, 1.0F);
  EXPECT_NEAR(water[0].color.g, 0.5, 0.01);
  EXPECT_EQ(water[0].color.b, 0.0F);
}

TEST(PhasePointsTest, TheIceFractionThatAllWaterHasInCommonIsTold) {
  for (const float fraction : {0.0F, 0.4F, 0.8F}) {
    Cloud cloud;
    cloud.add(1.0F, fraction, Phase::kWater);
    cloud.add(2.0F, fraction, Phase::kWater);
    cloud.add(3.0F, 0.0F, Phase::kSteam);  // neither steam nor ice counts
    cloud.add(4.0F, 1.0F, Phase::kIce);
    PhasePoints points;
    splitPhases(cloud.message, points);
    EXPECT_EQ(countOf(points, Phase::kWater), 2U);
    EXPECT_EQ(points.freezing, fraction);
  }
}

TEST(PhasePointsTest, NothingIsLeftOfTheCloudBefore) {
  Cloud cloud;
  cloud.add(1.0F, 0.0F, Phase::kWater);
  cloud.add(1.0F, 1.0F, Phase::kIce);
  PhasePoints points;
  splitPhases(cloud.message, points);
  splitPhases(Cloud().message, points);
  for (const auto& of_phase : points.of) EXPECT_TRUE(of_phase.empty());
}

TEST(PhasePointsTest, ACloudWithoutPhasesIsWaterAndSaysSo) {
  Cloud cloud;
  cloud.add(1.0F, 0.0F, Phase::kWater);
  cloud.add(2.0F, 1.0F, Phase::kIce, 0.9F);
  cloud.add(3.0F, 0.0F, Phase::kSteam, 0.0F);
  cloud.removePhase();
  PhasePoints points;
  splitPhases(cloud.message, points);
  EXPECT_EQ(countOf(points, Phase::kWater), 3U);
  EXPECT_FALSE(points.has_phases);
}

TEST(PhasePointsTest, PlainCloudIsWater) {
  Cloud cloud;
  cloud.add(1.0F, 1.0F, Phase::kIce, 0.0F);
  cloud.message.fields.resize(3);
  PhasePoints points;
  splitPhases(cloud.message, points);
  ASSERT_EQ(countOf(points, Phase::kWater), 1U);
  EXPECT_EQ(points.freezing, 0.0F);
  EXPECT_GT(points.of[indexOf(Phase::kWater)][0].color.b, 0.5F);
}

TEST(PhasePointsTest, BrokenCloudsAreRefused) {
  PhasePoints points;
  Cloud short_of_bytes;
  short_of_bytes.add(1.0F, 1.0F, Phase::kIce);
  short_of_bytes.message.width = 2;
  EXPECT_THROW(splitPhases(short_of_bytes.message, points), std::invalid_argument);
  Cloud beyond;
  beyond.add(1.0F, 0.0F, Phase::kWater);
  beyond.message.fields[0].offset = 26;
  EXPECT_THROW(splitPhases(beyond.message, points), std::invalid_argument);
  EXPECT_THROW(splitPhases(sensor_msgs::PointCloud2(), points), std::invalid_argument);
  Cloud unknown;
  unknown.add(1.0F, 0.0F, Phase::kWater);
  unknown.message.data[Cloud::PHASE_AT] = 4;
  EXPECT_THROW(splitPhases(unknown.message, points), std::invalid_argument);
}

}  // namespace
}  // namespace ice_ice_baby
