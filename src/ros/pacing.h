// When the next frame or message is due, and the real-time factor.
#pragma once

#include <ros/time.h>

#include <chrono>
#include <deque>
#include <limits>
#include <utility>

namespace ice_ice_baby {

using WallClock = std::chrono::steady_clock;

/// Paces frames by the machine's clock, or by ROS time that another node publishes. Time lost to
/// slow frames or a pause is not caught up. Frames stop while ROS time stands still, and continue
/// from the new time when it jumps back. Only a shorter interval makes a frame due sooner, so
/// commands never speed frames up.
class Pacer {
 public:
  /// @param interval_s between frames, 0: always due @param ros_time whether to follow ros::Time
  Pacer(double interval_s, bool ros_time) : interval_s_(interval_s), ros_time_(ros_time) {}

  /// The next frame is due at the latest one interval from now.
  void setInterval(double interval_s);

  /// Seconds until the next frame; 0 if it is due, as the first one always is.
  double remaining();

  /// Counts a frame that begins now.
  /// @returns seconds since it was due; 0 if that is more than half an interval, because the frame
  /// then counts as one that is due now
  double frameBegins();

 private:
  double now() const;

  double interval_s_;
  bool ros_time_;
  double due_s_ = -std::numeric_limits<double>::infinity();
  double latest_s_ = 0.0;
};

/// Ratio of simulated to wall time over the latest second.
class RealTimeFactor {
 public:
  void add(WallClock::time_point now, double simulated_s);
  /// Frames have stopped, so the factor is 0.
  void clear() { samples_.clear(); }
  double value() const;

 private:
  std::deque<std::pair<WallClock::time_point, double>> samples_;
};

/// Allows at most `rate_hz` messages per second of wall time, and on average that many if asked
/// more often.
class RateGate {
 public:
  explicit RateGate(double rate_hz) : rate_hz_(rate_hz) {}

  bool off() const { return rate_hz_ <= 0.0; }
  /// Whether a message may go out now; if so, it is counted. @param urgent whether to ignore the
  /// rate
  bool pass(WallClock::time_point now, bool urgent);
  WallClock::time_point latest() const { return latest_; }

 private:
  double rate_hz_;
  WallClock::time_point due_{};
  WallClock::time_point latest_{};
};

}  // namespace ice_ice_baby
