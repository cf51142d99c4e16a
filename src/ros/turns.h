// Rotation vectors: axis times angle.
#pragma once

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Rotation vector of a rotation, of length 0 to pi, rad.
inline Vec3d turnOf(const Mat3<double>& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// Rotation by a rotation vector, rad.
inline Mat3<double> rotationBy(const Vec3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Mat3<double>::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

/// The vector, shortened to at most `length`.
inline Vec3d bounded(const Vec3d& vector, double length) {
  const double norm = vector.norm();
  return norm > length ? Vec3d(vector * (length / norm)) : vector;
}

/// Largest speed from which a body can still stop within `distance`, in steps of `step_s`, slowing
/// down by at most `deceleration` times `step_s` in each.
inline double stoppingSpeed(double distance, double deceleration, double step_s) {
  const double half_s = step_s / 2;
  const double speed =
      deceleration * (std::sqrt(half_s * half_s + 2 * distance / deceleration) - half_s);
  return std::min(speed, distance / step_s);
}

}  // namespace ice_ice_baby
