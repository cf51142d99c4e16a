// The inside of a vessel or gauge as a body that can be filled.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// A box in the frame of the vessel, or the upright cylinder inscribed in it.
struct VesselSpace {
  Vec3d low = Vec3d::Zero();   ///< m
  Vec3d high = Vec3d::Zero();  ///< m
  bool round = false;

  bool holds(const Vec3d& point) const {
    const bool in_box =
        (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
    return in_box && (!round || point.head<2>().squaredNorm() <= high.x() * high.x());
  }
  double capacity_m3() const;
  /// Radius of a ball about `centre()` that holds it, m.
  double reach_m() const { return (high - low).norm() / 2; }
  Vec3d centre() const { return (low + high) / 2; }
  /// Height of its lowest point along the unit vector `up`, m.
  double lowest_m(const Vec3d& up) const;
};

VesselSpace spaceOf(const Container& container);
VesselSpace spaceOf(const Cup& cup);
VesselSpace spaceOf(const Gauge& gauge);

}  // namespace ice_ice_baby
