#include "pose_playback.h"

#include <algorithm>
#include <cmath>

#include "turns.h"

namespace ice_ice_baby {

namespace {

constexpr double kMaxDelay_s = 0.5;
constexpr double kJump_s = 1.0;  ///< a delay that changes by more is of a clock that was set
/// Change of the delay, s per s: it grows fast, because until then samples are missing.
constexpr double kSlower = 0.5, kFaster = 0.05;

constexpr double kIntervals = 1.5, kBeyond_s = 0.1;  ///< how far the motion continues unchanged
constexpr double kBrake_s = 0.2;
constexpr double kSilent_s = 1.0;  ///< then the last pose counts

constexpr double kJoin_m_s2 = 5.0, kJoin_rad_s2 = 50.0;

/// Lets an offset end with bounded acceleration.
void shrink(Vec3d& offset, Vec3d& rate, double acceleration, double step_s) {
  const double length = offset.norm();
  Vec3d wanted = Vec3d::Zero();
  if (length > 0.0) {
    wanted = -offset * (stoppingSpeed(length, acceleration, step_s) / length);
  }
  const bool ends =
      wanted.norm() * step_s >= length && (wanted - rate).norm() <= acceleration * step_s;
  rate = ends ? Vec3d::Zero() : Vec3d(rate + bounded(wanted - rate, acceleration * step_s));
  offset = ends ? Vec3d::Zero() : Vec3d(offset + rate * step_s);
}

}  // namespace

std::optional<PosePlayback::Played> PosePlayback::play(double stamp_s) {
  if (samples_.empty()) return std::nullopt;
  double step_s = stamp_s - stamp_s_;
  // Not a step between two frames: the clock jumped, or frames stopped.
  if (!(step_s > 0.0 && step_s < kSilent_s)) step_s = settings_.frame_s;
  stamp_s_ = stamp_s;
  followDelay(step_s);
  const Reading reading = read(stamp_s - delay_s_);
  const bool placed = !started_ || reading.segment != last_.segment;
  if (placed) {
    offset_m_ = offset_m_s_ = turn_rad_ = turn_rad_s_ = Vec3d::Zero();
    anchor_s_ = samples_.newest().stamp_s;
    epoch_ = samples_.epoch();
  } else {
    join(reading, step_s);
  }
  started_ = true;
  last_ = reading;
  return Played{{reading.pose.position + offset_m_, rotationBy(turn_rad_) * reading.pose.rotation},
                placed};
}

double PosePlayback::wantedDelay_s() const {
  if (settings_.delay_s >= 0.0) return settings_.delay_s;
  const double latency_s = samples_.latency_s();
  const double clocks_s = std::abs(latency_s) > kMaxDelay_s ? latency_s : 0.0;
  if (settings_.simulated_time) {
    const double interval_s = samples_.interval_s();
    const bool each_frame = interval_s < 1.1 * settings_.frame_s;
    return clocks_s + std::max(0.0, latency_s - clocks_s) +
           (each_frame ? 0.0 : std::min(interval_s, kMaxDelay_s));
  }
  return clocks_s + std::min(kMaxDelay_s, samples_.silence_s() - clocks_s + settings_.frame_s);
}

void PosePlayback::followDelay(double step_s) {
  const double change_s = wantedDelay_s() - delay_s_;
  const bool set = !started_ || std::abs(change_s) > kJump_s;
  delay_s_ += set ? change_s : std::clamp(change_s, -kFaster * step_s, kSlower * step_s);
}

PosePlayback::Reading PosePlayback::read(double stamp_s) const {
  return stamp_s > samples_.newest().stamp_s ? readBeyond(stamp_s) : samples_.at(stamp_s, fits());
}

PosePlayback::Reading PosePlayback::readBeyond(double stamp_s) const {
  const double beyond_s = stamp_s - samples_.newest().stamp_s;
  if (beyond_s > kSilent_s) return samples_.at(stamp_s, false);
  Reading reading = samples_.end(fits());
  const double rate_hz = samples_.rate_hz();
  const double free_s = rate_hz > 0.0 ? std::min(kIntervals / rate_hz, kBeyond_s) : 0.0;
  const double brake_s = std::clamp(beyond_s - free_s, 0.0, kBrake_s);
  const double path_s = std::min(beyond_s, free_s) + brake_s * (1.0 - brake_s / (2 * kBrake_s));
  reading.pose.position += path_s * reading.velocity_m_s;
  reading.pose.rotation = rotationBy(path_s * reading.spin_rad_s) * reading.pose.rotation;
  reading.velocity_m_s *= 1.0 - brake_s / kBrake_s;
  reading.spin_rad_s *= 1.0 - brake_s / kBrake_s;
  return reading;
}

/// Where the source of poses changes, the pose and its velocity continue and the difference becomes
/// the offset.
void PosePlayback::join(const Reading& reading, double step_s) {
  const double newest_s = samples_.newest().stamp_s;
  const bool moved_end = reading.source == PoseSamples::Source::kEnd && newest_s != anchor_s_;
  if (reading.source != last_.source || moved_end || samples_.epoch() != epoch_) {
    epoch_ = samples_.epoch();
    anchor_s_ = newest_s;
    const Vec3d velocity = last_.velocity_m_s + offset_m_s_;
    const Vec3d spin = last_.spin_rad_s + turn_rad_s_;
    const Vec3d was_m = last_.pose.position + offset_m_;
    const Mat3<double> was = rotationBy(turn_rad_) * last_.pose.rotation;
    offset_m_ = was_m - (reading.pose.position - step_s * reading.velocity_m_s);
    turn_rad_ =
        turnOf(was * reading.pose.rotation.transpose() * rotationBy(step_s * reading.spin_rad_s));
    offset_m_s_ = velocity - reading.velocity_m_s;
    turn_rad_s_ = spin - reading.spin_rad_s;
  }
  shrink(offset_m_, offset_m_s_, kJoin_m_s2, step_s);
  shrink(turn_rad_, turn_rad_s_, kJoin_rad_s2, step_s);
}

}  // namespace ice_ice_baby
