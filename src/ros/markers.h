// Springs and colliders as markers.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Points of one line marker at most; rviz stumbles over longer ones.
constexpr std::size_t kMaxMarkerPoints = 16000;

/// Springs as lines. @param header of every marker @param width_m of a line
/// @param clear whether what an earlier message drew is deleted first
visualization_msgs::MarkerArray springMarkers(const std::vector<SpringSample>& springs,
                                              const std_msgs::Header& header, double width_m,
                                              bool clear);

/// Every collider of the scene where it stands now, as translucent as its opacity says: its
/// surface, and the edges of a container. One of opacity 0 is not drawn. Deletes what an earlier
/// message drew first.
visualization_msgs::MarkerArray colliderMarkers(const Simulation& simulation,
                                                const std_msgs::Header& header);

}  // namespace ice_ice_baby
