#include "flow/outlet_motion.h"

#include "colliders/motion.h"

namespace ice_ice_baby {

OutletMotion::OutletMotion(const Source& source)
    : start_(source.pose()), target_(start_), placed_(source.follow_frame.empty()) {}

void OutletMotion::moveTo(const Posed& pose) {
  if (!placed_) return place(pose);
  target_ = pose;
}

void OutletMotion::place(const Posed& pose) {
  start_ = target_ = pose;
  placed_ = true;
}

void OutletMotion::jump(double radius_m, double max_m) {
  if (!moves()) return;
  const double far_m = (target_.position - start_.position).norm() + turn_rad().norm() * radius_m;
  if (far_m > max_m) start_ = target_;
}

/// Exactly where it is while it stands: interpolation rounds.
Posed OutletMotion::at(double fraction) const {
  return moves() ? between(start_, target_, fraction) : start_;
}

Vec3d OutletMotion::velocityAt(const Vec3d& point_m, const Posed& now, double frame_s) const {
  if (!moves()) return Vec3d::Zero();
  const Vec3d step_m = target_.position - start_.position;
  return (step_m + turn_rad().cross(point_m - now.position)) / frame_s;
}

bool OutletMotion::moves() const {
  return start_.position != target_.position || start_.rotation != target_.rotation;
}

/// Turn over the frame, about an axis of the scene.
Vec3d OutletMotion::turn_rad() const {
  const Eigen::AngleAxisd turn(target_.rotation * start_.rotation.transpose());
  return turn.angle() * turn.axis();
}

}  // namespace ice_ice_baby
