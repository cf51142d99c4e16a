// Topics of the floating solids: poses and velocities, and markers of their true shapes.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "ice_ice_baby/simulation.h"
#include "pacing.h"

namespace ice_ice_baby {

/// The topics exist only while the scene has solids. All of it is called by the simulation's
/// thread.
class SolidTopics {
 public:
  /// @param node with the private names
  /// @param rate_hz messages per second of wall time, at most one per frame; 0: none
  SolidTopics(const ros::NodeHandle& node, std::string scene_frame, double rate_hz);

  void sceneStarted(const Simulation& simulation);
  /// Publishes to whom subscribes, if a message is due.
  /// @param last whether no frame follows by itself
  void publish(const Simulation& simulation, const ros::Time& stamp, bool last);

 private:
  bool due(const Simulation& simulation, bool last);
  void publishStates(const std::vector<SolidState>& states, double time_s,
                     const std_msgs::Header& header);
  void publishMarkers(const std::vector<SolidState>& states, const std_msgs::Header& header);

  ros::NodeHandle node_;
  std::string scene_frame_;
  double rate_hz_;
  RateGate gate_;
  ros::Publisher states_, markers_;
  visualization_msgs::MarkerArray shapes_;  ///< one per solid of the scene, without poses
  std::uint64_t frame_ = 0;                 ///< of the latest messages
  std::uint32_t listeners_ = 0;             ///< subscribers of the latest messages
};

}  // namespace ice_ice_baby
