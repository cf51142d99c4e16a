// The stamp of messages, and simulated time on /clock where the user asked for it.
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "pacing.h"

namespace ice_ice_baby {

/// The clock starts at the machine's time, so that it does not go back when the node starts again,
/// runs on over resets and stands still while paused. One clock per system: while another node
/// publishes /clock this one stays silent, until the node starts again.
class ClockPublisher {
 public:
  /// @param wanted false: stamps are ros::Time::now() and nothing is published
  ClockPublisher(ros::NodeHandle& node, bool wanted);

  /// Stamp of what is published now.
  ros::Time stamp() const;

  /// Publishes at most 100 times a second. @param simulated_s since the node started
  void tick(double simulated_s);

  /// Asks the master who else publishes /clock, and falls silent if somebody does. May wait.
  void checkConflict();

  bool wanted() const { return wanted_; }
  /// Name of the other publisher, "" where there is none.
  std::string conflict() const;

 private:
  const bool wanted_;
  const ros::Time start_;
  RateGate gate_{100.0};

  mutable std::mutex mutex_;  ///< guards what follows
  ros::Publisher publisher_;
  ros::Time now_;
  std::string conflict_;
};

}  // namespace ice_ice_baby
