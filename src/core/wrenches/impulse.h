// Linear and angular impulses.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// An impulse, or a momentum: linear in kg m/s and angular about the origin of the world in kg
/// m^2/s.
struct Impulse {
  Vec3d linear = Vec3d::Zero();
  Vec3d angular = Vec3d::Zero();

  void add(const Vec3d& point_m, const Vec3d& part) {
    linear += part;
    angular += point_m.cross(part);
  }
  Impulse& operator+=(const Impulse& other) {
    linear += other.linear;
    angular += other.angular;
    return *this;
  }
  Impulse& operator-=(const Impulse& other) {
    linear -= other.linear;
    angular -= other.angular;
    return *this;
  }
  Impulse operator*(double factor) const { return {factor * linear, factor * angular}; }
};

}  // namespace ice_ice_baby
