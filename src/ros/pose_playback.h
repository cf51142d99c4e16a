// Plays the poses of a tf frame back a little later, smoothly whatever arrives.
#pragma once

#include <algorithm>
#include <optional>

#include "pose_samples.h"

namespace ice_ice_baby {

struct PlaybackSettings {
  /// Delay, s; negative: automatic. That is the largest (arrival - previous stamp) of the last 2 s
  /// plus a frame, at most 0.5 s beyond a difference of the clocks; in simulated time the smallest
  /// (arrival - stamp), usually 0, plus the interval of samples that come less often than frames.
  double delay_s = -1.0;
  bool simulated_time = false;  ///< the robot waits for the clock, so nothing is late
  double frame_s = 1.0 / 60.0;
  Teleport teleport;
};

/// Poses at stamp - delay. Without a sample that is new enough the motion continues for 1.5
/// intervals, at most 0.1 s, and slows down to rest within 0.2 s; after 1 s it returns to the last
/// pose. It joins the samples again with at most 5 m/s^2 and 50 rad/s^2. Knows no ROS.
class PosePlayback {
 public:
  explicit PosePlayback(const PlaybackSettings& settings = {})
      : settings_(settings), samples_(settings.teleport) {}

  /// @returns false for a sample that changes nothing; see PoseSamples::add
  bool add(const PoseSample& sample) { return samples_.add(sample); }

  struct Played {
    Posed pose;
    bool placed = false;  ///< the first pose, or one after a teleport: not reached by moving
  };
  /// The pose for a frame with this stamp, s; nothing without samples.
  std::optional<Played> play(double stamp_s);

  /// The next play() starts as the first one. Samples are kept.
  void restart() { started_ = false; }

  const PoseSamples& samples() const { return samples_; }
  /// Stamp of the newest sample that a frame with this stamp needs, s, once the delay has changed
  /// as it has to; not empty.
  double neededStamp_s(double stamp_s) const {
    return stamp_s - std::max(delay_s_, wantedDelay_s());
  }
  /// Delay now, s. It changes slowly, by at most 0.5 s per s.
  double delay_s() const { return delay_s_; }

 private:
  using Reading = PoseSamples::Reading;

  double wantedDelay_s() const;
  void followDelay(double step_s);
  bool fits() const { return !settings_.simulated_time || settings_.delay_s > 0.0; }
  Reading read(double stamp_s) const;
  Reading readBeyond(double stamp_s) const;
  void join(const Reading& reading, double step_s);

  const PlaybackSettings settings_;
  PoseSamples samples_;
  bool started_ = false;
  double delay_s_ = 0.0;
  double stamp_s_ = 0.0;  ///< of the last frame

  // The pose is what the samples say, plus an offset that ends soon.
  Reading last_;
  std::uint64_t epoch_ = 0;
  double anchor_s_ = 0.0;  ///< newest stamp while the motion continues beyond it
  Vec3d offset_m_ = Vec3d::Zero(), offset_m_s_ = Vec3d::Zero();
  Vec3d turn_rad_ = Vec3d::Zero(), turn_rad_s_ = Vec3d::Zero();
};

}  // namespace ice_ice_baby
