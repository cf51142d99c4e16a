// Springs, colliders and floating solids as markers.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Maximum number of points of a line marker; rviz has trouble with longer ones.
constexpr std::size_t kMaxMarkerPoints = 16000;

/// Springs as lines. @param width_m of a line
/// @param clear whether the lines of earlier messages are deleted
visualization_msgs::MarkerArray springMarkers(const std::vector<SpringSample>& springs,
                                              const std_msgs::Header& header, double width_m,
                                              bool clear);

/// Markers of all colliders, as translucent as their opacity says: their surfaces, and the edges of
/// containers. Colliders of opacity 0 are left out. The first marker deletes what an
/// earlier message drew.
/// @param poses of the colliders of `scene`, in the order of forEachCollider
visualization_msgs::MarkerArray colliderMarkers(const Scene& scene, const std::vector<Posed>& poses,
                                                const std_msgs::Header& header);

/// The true shape of every floating solid, one marker each, with its name as namespace and at the
/// origin of `header`; solids of opacity 0 are left out.
visualization_msgs::MarkerArray solidMarkers(const Scene& scene, const std_msgs::Header& header);

}  // namespace ice_ice_baby
