#include "pacing.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

double seconds(WallClock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

double Pacer::now() const {
  return ros_time_ ? ros::Time::now().toSec() : seconds(WallClock::now().time_since_epoch());
}

void Pacer::setInterval(double interval_s) {
  interval_s_ = interval_s;
  due_s_ = std::min(due_s_, now() + interval_s);
}

double Pacer::remaining() {
  if (interval_s_ <= 0.0) return 0.0;
  const double time_s = now();
  const bool jumped_back = time_s < latest_s_;
  latest_s_ = time_s;
  if (ros_time_ && time_s == 0.0) return interval_s_;  // no clock yet
  if (jumped_back) due_s_ = std::min(due_s_, time_s + interval_s_);
  return std::max(0.0, due_s_ - time_s);
}

double Pacer::frameBegins() {
  const double time_s = now();
  const double late_s = time_s - due_s_;
  due_s_ = (late_s > interval_s_ ? time_s : due_s_) + interval_s_;
  return late_s > interval_s_ / 2 ? 0.0 : std::max(0.0, late_s);
}

void RealTimeFactor::add(WallClock::time_point now, double simulated_s) {
  samples_.emplace_back(now, simulated_s);
  while (samples_.size() > 2 && now - samples_[1].first >= std::chrono::seconds(1)) {
    samples_.pop_front();
  }
}

double RealTimeFactor::value() const {
  if (samples_.size() < 2) return 0.0;
  const double wall_s = seconds(samples_.back().first - samples_.front().first);
  return wall_s > 0.0 ? (samples_.back().second - samples_.front().second) / wall_s : 0.0;
}

bool RateGate::pass(WallClock::time_point now, bool urgent) {
  if (off() || (now < due_ && !urgent)) return false;
  const auto period = std::chrono::duration_cast<WallClock::duration>(
      std::chrono::duration<double>(1.0 / rate_hz_));
  due_ = now - due_ > period || urgent ? now + period : due_ + period;
  latest_ = now;
  return true;
}

}  // namespace ice_ice_baby
