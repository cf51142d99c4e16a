// What users change between frames: each is checked whole before anything changes.
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulator.h"

namespace ice_ice_baby {

namespace {

bool still(const Vec3d& a, const Vec3d& b) { return (a - b).squaredNorm() == 0.0; }

}  // namespace

template <class Real>
void Simulator<Real>::setTemperature(double celsius, double ramp_s) {
  requireTemperature(celsius, ramp_s);
  temperature_.set(celsius, ramp_s);
  updateTemperature(report_.time_s);
}

template <class Real>
void Simulator<Real>::setGravity(const Vec3d& gravity_m_s2) {
  requireGravity(gravity_m_s2);
  if (still(gravity_m_s2, scene_.gravity_m_s2)) return;
  scene_.gravity_m_s2 = gravity_m_s2;
  wake();
}

template <class Real>
void Simulator<Real>::moveCollider(const std::string& name, const Posed& pose) {
  const Posed now = colliders_.pose(name);
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange("position of collider " + name, pose.position[axis], kCoordinateRange_m.min,
                   kCoordinateRange_m.max);
  }
  // A mirror is unitary too, but its determinant is -1.
  const auto& turn = pose.rotation;
  if (!turn.allFinite() || !turn.isUnitary(1e-6) || turn.determinant() < 0.0) {
    throw InvalidInput("rotation of collider " + name + " must be a unit quaternion");
  }
  const bool there = still(now.position, pose.position) && now.rotation == pose.rotation;
  if (there && !colliders_moving_) return;
  colliders_.moveTo(name, pose);
  colliders_moving_ = true;
  wake();
}

void requireTemperature(double celsius, double ramp_s) {
  requireInRange("temperature in degrees Celsius", celsius, kTemperatureRange_c.min,
                 kTemperatureRange_c.max);
  requireInRange("ramp in seconds", ramp_s, 0.0, 1e6);
}

void requireGravity(const Vec3d& gravity_m_s2) {
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange(std::string("gravity ") + "xyz"[axis] + " in m/s^2", gravity_m_s2[axis],
                   kGravityRange_m_s2.min, kGravityRange_m_s2.max);
  }
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
