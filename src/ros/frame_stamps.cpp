#include "frame_stamps.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

/// Gains of the loop: critically damped, with a time constant of about 20 frames.
constexpr double kPhase = 0.1, kPeriod = 0.0025;
constexpr double kGap_s = 0.1;  ///< a larger deviation is a pause or a jump of the clock

}  // namespace

double FrameStamps::next(double begin_s) {
  const double error_s = begin_s - (stamp_s_ + period_s_);
  if (frames_ == 0 || (frames_ == 2 && std::abs(error_s) > kGap_s)) {
    frames_ = 1;
    return stamp_s_ = begin_s;
  }
  if (frames_ == 1) {
    const double period_s = begin_s - stamp_s_;
    if (period_s >= 0.0 && period_s <= kGap_s) frames_ = 2;
    period_s_ = period_s;
    return stamp_s_ = begin_s;
  }
  stamp_s_ = std::max(stamp_s_, stamp_s_ + period_s_ + kPhase * error_s);
  period_s_ = std::max(0.0, period_s_ + kPeriod * error_s);
  return stamp_s_;
}

}  // namespace ice_ice_baby
