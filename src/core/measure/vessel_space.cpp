#include "measure/vessel_space.h"

#include <cmath>

namespace ice_ice_baby {

double VesselSpace::capacity_m3() const {
  const double box_m3 = (high - low).prod();
  return round ? M_PI / 4 * box_m3 : box_m3;
}

double VesselSpace::lowest_m(const Vec3d& up) const {
  const Vec3d lowest = (up.array() > 0).select(low, high);
  if (!round) return up.dot(lowest);
  return up.z() * lowest.z() - high.x() * up.head<2>().norm();
}

VesselSpace spaceOf(const Container& c) {
  const Vec3d half(c.size_m.x() / 2, c.size_m.y() / 2, 0.0);
  return {-half, Vec3d(half.x(), half.y(), c.size_m.z()), false};
}

VesselSpace spaceOf(const Cup& c) {
  return {Vec3d(-c.radius_m, -c.radius_m, 0.0), Vec3d(c.radius_m, c.radius_m, c.depth_m), true};
}

VesselSpace spaceOf(const Gauge& g) { return {-g.size_m / 2, g.size_m / 2, false}; }

}  // namespace ice_ice_baby
