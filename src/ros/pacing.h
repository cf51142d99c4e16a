// When the next frame is due, and how fast simulated time has run.
#pragma once

#include <ros/time.h>

#include <chrono>
#include <deque>
#include <limits>
#include <utility>

namespace ice_ice_baby {

using WallClock = std::chrono::steady_clock;

/// Holds frames to a clock: the machine's own, or ROS time that another node publishes. Time lost
/// to slow frames or a pause is dropped, not caught up. When ROS time stands still, so do the
/// frames; when it jumps back, they go on from there. Nothing but a shorter interval makes a frame
/// due sooner, so that commands, however many, do not hurry the frames.
class Pacer {
 public:
  /// @param interval_s between two frames, 0: always due @param ros_time follow ros::Time
  Pacer(double interval_s, bool ros_time) : interval_s_(interval_s), ros_time_(ros_time) {}

  /// Counts from now, where that is sooner than what was due.
  void setInterval(double interval_s);

  /// Seconds until the next frame, 0 when it is due now, as the first is.
  double remaining();

  /// Counts a frame that begins now.
  void frameBegins();

 private:
  double now() const;

  double interval_s_;
  bool ros_time_;
  double due_s_ = -std::numeric_limits<double>::infinity();
  double latest_s_ = 0.0;
};

/// Simulated over wall time in the latest second.
class RealTimeFactor {
 public:
  void add(WallClock::time_point now, double simulated_s);
  /// Frames stopped: 0 from now on.
  void clear() { samples_.clear(); }
  double value() const;

 private:
  std::deque<std::pair<WallClock::time_point, double>> samples_;
};

/// Lets through at most `rate_hz` messages per second of wall time, on average exactly that when
/// asked more often.
class RateGate {
 public:
  explicit RateGate(double rate_hz) : rate_hz_(rate_hz) {}

  bool off() const { return rate_hz_ <= 0.0; }
  /// Whether a message may go out now, which is then counted. @param urgent it must, whatever rate
  bool pass(WallClock::time_point now, bool urgent);
  WallClock::time_point latest() const { return latest_; }

 private:
  double rate_hz_;
  WallClock::time_point due_{};
  WallClock::time_point latest_{};
};

}  // namespace ice_ice_baby
