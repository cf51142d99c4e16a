// Which displays follow the temperature, and how far.
#include "water_opacity.h"

#include <gtest/gtest.h>
#include <ros/init.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/properties/property.h>

#include <QApplication>

namespace ice_ice_baby {
namespace {

/// A display as far as opacity is concerned, owned by its group.
rviz::Property* addCloud(rviz::DisplayGroup& group, const QString& kind, const QString& topic) {
  auto* display = new rviz::Display;
  display->setClassId(kind);
  new rviz::Property("Topic", topic, "", display);
  auto* alpha = new rviz::Property("Alpha", 1.0, "", display);
  group.addDisplay(display);
  return alpha;
}

TEST(WaterOpacityTest, RisesFromTranslucentWaterToOpaqueIce) {
  EXPECT_NEAR(waterOpacity(0.0), 0.6, 1e-6);
  EXPECT_NEAR(waterOpacity(0.5), 0.8, 1e-6);
  EXPECT_EQ(waterOpacity(1.0), 1.0F);
  EXPECT_EQ(waterOpacity(7.0), 1.0F);
}

TEST(WaterOpacityTest, OnlyCloudsOfTheNodeFollow) {
  rviz::DisplayGroup group;
  rviz::Property* water = addCloud(group, "rviz/PointCloud2", "/ice_ice_baby/particles");
  rviz::Property* lidar = addCloud(group, "rviz/PointCloud2", "/lidar");
  rviz::Property* marker = addCloud(group, "rviz/MarkerArray", "/ice_ice_baby/particles");
  showOpacity(&group, "/ice_ice_baby/particles", 0.7F);
  EXPECT_NEAR(water->getValue().toDouble(), 0.7, 1e-6);
  EXPECT_EQ(lidar->getValue().toDouble(), 1.0);
  EXPECT_EQ(marker->getValue().toDouble(), 1.0);
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "water_opacity_test");
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
