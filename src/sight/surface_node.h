// The node that publishes the surface of the water of a simulation.
#pragma once

#include <ice_ice_baby/State.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <sensor_msgs/PointCloud2.h>

#include "pacing.h"

namespace ice_ice_baby {

/// Publishes `surface` and `surface_markers` beside the topics of the simulation, from a thread of
/// its own. It subscribes to the particles only while one of the two has a subscriber. A surface
/// that takes longer than the particles come skips some of them; nobody waits for it.
class SurfaceNode {
 public:
  /// Reads the private parameters `simulation`, the name of the simulation's node, and `rate_hz`.
  /// @throws InvalidInput for a parameter out of range, or if this program makes no surfaces
  SurfaceNode(const ros::NodeHandle& node, const ros::NodeHandle& node_private);
  ~SurfaceNode() { spinner_.stop(); }

 private:
  void followSubscribers();
  void takeState(const State::ConstPtr& state);
  void takeParticles(const sensor_msgs::PointCloud2::ConstPtr& cloud);
  void publish();

  ros::CallbackQueue queue_;
  ros::NodeHandle simulation_;  ///< its names
  RateGate gate_;
  ros::Publisher surface_, markers_;
  ros::Subscriber particles_, states_;
  State::ConstPtr state_;                       ///< the latest
  sensor_msgs::PointCloud2::ConstPtr waiting_;  ///< the latest, until its surface is published
  ros::AsyncSpinner spinner_;
};

}  // namespace ice_ice_baby
