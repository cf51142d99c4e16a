// Sends interactive markers, and receives where they are dragged.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <visualization_msgs/InteractiveMarker.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ice_ice_baby {

class MarkerServer {
 public:
  virtual ~MarkerServer() = default;

  /// Shows these markers instead of all others.
  virtual void show(const std::vector<visualization_msgs::InteractiveMarker>& markers) = 0;
  /// Moves a marker.
  virtual void put(const std::string& marker, const geometry_msgs::Pose& pose) = 0;
};

/// @param topics beginning of the names of its topics: update, update_full, feedback
/// @param dragged called on a thread of the server with the name and the new pose of a marker
/// @throws InvalidInput if this program was built without libinteractive-markers-dev
std::unique_ptr<MarkerServer> makeMarkerServer(
    const std::string& topics,
    std::function<void(const std::string&, const geometry_msgs::PoseStamped&)> dragged);

}  // namespace ice_ice_baby
