// Interactive markers for what people drag in rviz.
#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <vector>

#include "steered.h"

namespace ice_ice_baby {

/// A part of the scene without a `follow_frame`, and the marker that moves it: arrows along the
/// axes and rings about them. Sources and heat regions, which no other topic shows, are drawn too.
/// The name of the marker is what.words().
struct Handle {
  Steered what;
  visualization_msgs::InteractiveMarker marker;
};

/// All of a scene, in the order of everySteered; infinite planes have none.
/// @param scene_frame tf frame of the markers
std::vector<Handle> everyHandle(const Scene& scene, const std::string& scene_frame);

}  // namespace ice_ice_baby
