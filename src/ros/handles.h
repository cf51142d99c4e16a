// Moves what people drag in rviz.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "handle_markers.h"
#include "marker_server.h"
#include "motion_limit.h"
#include "parameters.h"

namespace ice_ice_baby {

/// Interactive markers for every part of the scene that follows no tf frame, with the parameter
/// ~handles. A part moves to where its marker is, within the bounds of parts that follow a frame.
class Handles {
 public:
  /// @throws InvalidInput as makeMarkerServer, if the parameter asks for markers
  Handles(const ros::NodeHandle& node_private, const NodeParameters& parameters);

  /// Simulation's thread, like the next two: a scene is at its start.
  void sceneStarted(const Simulation& simulation);
  /// Names of the colliders that can be dragged.
  const std::vector<std::string>& colliders() const { return colliders_; }
  /// Moves what was dragged over the next frame.
  void move(Simulation& simulation);

 private:
  /// A part on its way to its marker.
  struct Way {
    Posed end;
    MotionLimit limit;
  };
  struct Part {
    Steered what;
    std::optional<Way> way;
  };

  void drag(const std::string& marker, const geometry_msgs::PoseStamped& pose);
  void begin(const Simulation& simulation, Part& part, const Posed& end) const;
  void putBack(const Simulation& simulation, Part& part);
  void moveOne(Simulation& simulation, Part& part);

  const std::string scene_frame_;
  const MotionBounds bounds_;
  std::vector<Part> parts_;  ///< simulation's thread, with the next one
  std::vector<std::string> colliders_;
  std::mutex mutex_;  ///< guards dragged_
  /// Newest pose of each marker since the last frame; none if it cannot be used.
  std::map<std::string, std::optional<Posed>> dragged_;
  std::unique_ptr<MarkerServer> server_;  ///< null: none are wanted; ends before what it calls
};

}  // namespace ice_ice_baby
