// Bounds the speed and the acceleration of a collider that follows a tf frame.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// In simulated time.
struct MotionBounds {
  double speed_m_s = 5.0;
  double acceleration_m_s2 = 100.0;
  double turning_rad_s = 20.0;
};

/// Follows wanted poses exactly where the bounds allow it; otherwise as fast as they do, and
/// without overshoot once the wanted pose rests.
class MotionLimit {
 public:
  explicit MotionLimit(const MotionBounds& bounds = {}) : bounds_(bounds) {}

  /// Starts at a pose, at rest.
  void start(const Posed& pose);

  struct Step {
    Posed pose;
    double behind_m = 0.0;    ///< distance from the wanted pose, m; 0: not bounded
    double behind_rad = 0.0;  ///< angle from it, rad
  };
  /// Pose after the next `step_s` seconds.
  Step step(const Posed& wanted, double step_s);

 private:
  const MotionBounds bounds_;
  Posed pose_;
  Posed wanted_;
  Vec3d velocity_m_s_ = Vec3d::Zero();
};

}  // namespace ice_ice_baby
