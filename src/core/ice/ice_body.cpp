#include "ice/ice_body.h"

#include <cmath>

namespace ice_ice_baby {

Eigen::Quaterniond quaternionBy(const Vec3d& angle_rad) {
  const double angle = angle_rad.norm();
  const double half = angle / 2;
  // Series of sin(a) / a, as the division loses all precision here.
  const double scale = angle > 1e-6 ? std::sin(half) / angle : 0.5 - angle * angle / 48;
  const Vec3d axis = scale * angle_rad;
  return {std::cos(half), axis.x(), axis.y(), axis.z()};
}

void IceBody::moveTo(const Placement& placement) {
  next = placement;
  mobility_now = next.rotation_matrix * mobility * next.rotation_matrix.transpose();
}

void IceBody::push(const Vec3d& by_m, const Vec3d& rotation_rad, double dt_s) {
  velocity_m_s += by_m / dt_s;
  angular_momentum +=
      next.rotation_matrix * (inertia * (next.rotation_matrix.transpose() * rotation_rad)) / dt_s;
  moveTo({next.centre_m + by_m, quaternionBy(rotation_rad) * next.rotation});
}

Placement IceBody::flight(double dt_s) const {
  // Each pass of the implicit rule reduces its error by a factor of the rotation angle.
  constexpr int kPasses = 3;
  Vec3d mean_angular_velocity = angularVelocityAt(pose.rotation_matrix);
  for (int pass = 0; pass < kPasses; ++pass) {
    const Eigen::Quaterniond half =
        quaternionBy(mean_angular_velocity * (dt_s / 2)) * pose.rotation;
    mean_angular_velocity = angularVelocityAt(half.toRotationMatrix());
  }
  return {pose.centre_m + dt_s * velocity_m_s,
          quaternionBy(dt_s * mean_angular_velocity) * pose.rotation};
}

void IceBody::stop() {
  velocity_m_s.setZero();
  angular_momentum.setZero();
}

}  // namespace ice_ice_baby
