#include "framing.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr double kMargin = 1.08;

}  // namespace

double framingDistance(const Eigen::AlignedBox3d& box, const Orbit& orbit) {
  const Eigen::Vector3d to_eye(std::cos(orbit.yaw) * std::cos(orbit.pitch),
                               std::sin(orbit.yaw) * std::cos(orbit.pitch), std::sin(orbit.pitch));
  const Eigen::Vector3d right(-std::sin(orbit.yaw), std::cos(orbit.yaw), 0.0);
  const Eigen::Vector3d up = to_eye.cross(right);
  const double high = std::tan(0.5 * orbit.view_angle) / kMargin;
  const double wide = high * orbit.aspect;
  double distance = 0.0;
  for (int k = 0; k < 8; ++k) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(k);
    const Eigen::Vector3d way = box.corner(corner) - box.center();
    const double out = std::max(std::abs(way.dot(right)) / wide, std::abs(way.dot(up)) / high);
    distance = std::max(distance, way.dot(to_eye) + out);
  }
  return distance;
}

}  // namespace ice_ice_baby
