// A cloud of particles as points to draw: water, ice and steam apart. Draws nothing.
#pragma once

#include <rviz/ogre_helpers/point_cloud.h>
#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <vector>

namespace ice_ice_baby {

enum Phase { WATER, ICE, STEAM };

struct PhasePoints {
  std::array<std::vector<rviz::PointCloud::Point>, 3> of;  ///< by Phase
  float freezing = 0.0F;  ///< share of ice in what is drawn as water, where all of it has the same
};

/// Steam is what is hardly dense, ice what is more ice than water. Where all water and ice has one
/// share of ice, as in a scene without heat, it stays together as water and `freezing` tells that
/// share. Fields that a cloud lacks count as those of dense water.
/// @throws std::invalid_argument for a cloud without x, y, z or with fewer bytes than it says
void splitPhases(const sensor_msgs::PointCloud2& cloud, PhasePoints& out);

}  // namespace ice_ice_baby
