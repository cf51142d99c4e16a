// Time stamps of messages, and simulated time on /clock with ~publish_clock.
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "pacing.h"

namespace ice_ice_baby {

/// The clock starts at the machine's time, so that it does not go back when the node restarts. It
/// continues over resets and stops while paused. If another node publishes /clock, this one does
/// not, until it is restarted.
class ClockPublisher {
 public:
  /// @param wanted false: stamps are ros::Time::now() and nothing is published
  ClockPublisher(ros::NodeHandle& node, bool wanted);

  /// Stamp for messages published now.
  ros::Time stamp() const;

  /// Publishes at most 100 times a second. @param simulated_s since the node started
  void tick(double simulated_s);

  /// Asks the master for other publishers of /clock and stops publishing if there is one. May
  /// block.
  void checkConflict();

  bool wanted() const { return wanted_; }
  /// Name of the other publisher of /clock, "" if there is none.
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
