// Topics with the force and torque of water and ice on each collider.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "pacing.h"

namespace ice_ice_baby {

/// One topic per collider, wrenches/NAME, in the tf frame of the collider. Nothing is measured
/// without a subscriber. All of it is called by the simulation's thread.
class WrenchTopics {
 public:
  /// @param node with the private names
  /// @param rate_hz messages per second of wall time, at most one per frame
  WrenchTopics(const ros::NodeHandle& node, std::string scene_frame, double rate_hz);

  /// Replaces the topics of an earlier scene by those of the colliders of this one.
  void sceneStarted(const Simulation& simulation);
  void frameBegins(Simulation& simulation);
  /// Publishes the means since the latest messages, if they are due. @param news since then
  /// @param last whether no more news follows for a while @returns whether it did
  bool publish(const Simulation& simulation, const ros::Time& stamp, bool news, bool last);

 private:
  bool anySubscribed() const;

  ros::NodeHandle node_;
  std::string scene_frame_;
  double rate_hz_;
  RateGate gate_;
  std::vector<ros::Publisher> publishers_;  ///< (colliders)
  bool measuring_ = false;
  bool sent_ = false;  ///< since the latest frame began
};

}  // namespace ice_ice_baby
