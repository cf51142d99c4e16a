// A cloud of particles as points to draw: water, ice and steam apart. Draws nothing.
#pragma once

#include <rviz/ogre_helpers/point_cloud.h>
#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <iterator>
#include <vector>

#include "ice_ice_baby/samples.h"

namespace ice_ice_baby {

constexpr std::size_t indexOf(Phase phase) { return static_cast<std::size_t>(phase); }

struct PhasePoints {
  std::array<std::vector<rviz::PointCloud::Point>, std::size(kPhases)> of;  ///< by indexOf(Phase)
  float freezing = 0.0F;   ///< ice fraction of all water, where it has one in common; otherwise 0
  bool has_phases = true;  ///< whether the cloud tells the phase; without it all of it is water
};

/// Parts a cloud by its field `phase`. Slush is water; in a scene without heat all water has the
/// same ice fraction, which `freezing` tells. Other fields that a cloud lacks count as 0.
/// @throws std::invalid_argument for a cloud without x, y, z, with fewer bytes than it says, or
/// with an unknown phase
void splitPhases(const sensor_msgs::PointCloud2& cloud, PhasePoints& out);

}  // namespace ice_ice_baby
