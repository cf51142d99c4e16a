#include <cmath>

#include "ice_ice_baby/camera_params.h"

namespace ice_ice_baby {

Posed Camera::pose() const {
  const Vec3d ahead = (look_at_m - position_m).normalized();
  const Vec3d level = ahead.cross(Vec3d::UnitZ());
  const Vec3d right = level.norm() > 1e-9 ? Vec3d(level.normalized()) : Vec3d(Vec3d::UnitX());
  Mat3<double> axes;
  axes << right, ahead.cross(right), ahead;
  Posed pose;
  pose.position = position_m;
  pose.rotation = axes;
  return pose;
}

double Camera::focalLength() const { return 0.5 * width / std::tan(0.5 * fov_deg * M_PI / 180); }

}  // namespace ice_ice_baby
