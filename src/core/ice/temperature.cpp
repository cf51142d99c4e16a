#include "ice/temperature.h"

#include <algorithm>

namespace ice_ice_baby {

Temperature::Temperature(const Scene& scene)
    : params_(scene.temperature),
      schedule_(scene.schedule),
      celsius_(params_.initial_c),
      from_c_(params_.initial_c),
      target_c_(params_.initial_c) {
  std::stable_sort(schedule_.begin(), schedule_.end(),
                   [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  advanceTo(0.0);
}

void Temperature::startRamp(double target_c, double ramp_s, double start_s) {
  from_c_ = celsius_;
  target_c_ = target_c;
  ramp_s_ = ramp_s;
  ramp_start_s_ = start_s;
}

void Temperature::advanceTo(double time_s) {
  const auto follow = [&](double t) {
    const double done = ramp_s_ > 0.0 ? std::clamp((t - ramp_start_s_) / ramp_s_, 0.0, 1.0) : 1.0;
    celsius_ = done < 1.0 ? from_c_ + done * (target_c_ - from_c_) : target_c_;
  };
  while (!schedule_.empty() && schedule_.front().at_s <= time_s) {
    const TemperatureEvent event = schedule_.front();
    schedule_.erase(schedule_.begin());
    follow(event.at_s);
    startRamp(event.celsius, event.ramp_s, event.at_s);
  }
  follow(time_s);
  time_s_ = time_s;
}

void Temperature::set(double target_c, double ramp_s) {
  schedule_.clear();
  startRamp(target_c, ramp_s, time_s_);
  advanceTo(time_s_);
}

double Temperature::strictness() const {
  const double range = params_.onset_c - params_.freezing_c;
  return std::clamp((params_.onset_c - celsius_) / range, 0.0, 1.0);
}

}  // namespace ice_ice_baby
