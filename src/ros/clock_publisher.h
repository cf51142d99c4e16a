// Time stamps of messages, and simulated time on /clock with ~publish_clock.
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "frame_stamps.h"
#include "pacing.h"
#include "simulation_thread.h"

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

  /// Stamp of a frame that begins: the time at which colliders that follow tf are at its end. With
  /// simulated time of this node, that of its end; otherwise when it was due, made regular.
  /// @param announced whether to publish it on /clock at once, so that robots move on to it
  ros::Time frameStamp(const FrameBegin& frame, bool announced);

  /// Publishes at most 100 times a second. @param simulated_s since the node started
  void tick(double simulated_s);

  /// Asks the master for other publishers of /clock and stops publishing if there is one. May
  /// block.
  void checkConflict();

  bool wanted() const { return wanted_; }
  /// Name of the other publisher of /clock, "" if there is none.
  std::string conflict() const;

 private:
  bool simulates() const;
  void publish(bool urgent);

  const bool wanted_;
  const ros::Time start_;
  FrameStamps stamps_;  ///< simulation's thread, with the next one
  ros::Time origin_;    ///< of stamps_
  RateGate gate_{100.0};

  mutable std::mutex mutex_;  ///< guards what follows
  ros::Publisher publisher_;
  ros::Time now_;
  ros::Time published_;
  std::string conflict_;
};

}  // namespace ice_ice_baby
