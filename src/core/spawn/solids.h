// The solids of a scene as obstacles for particles at the start.
#pragma once

#include <Eigen/Geometry>

#include "colliders/collider_faces.h"
#include "colliders/colliders.h"

namespace ice_ice_baby {

/// The colliders at their initial poses, numbered as in forEachColliderList.
class Solids {
 public:
  /// @param radius_m of the particles; 0: only their centres count
  Solids(const Scene& scene, double radius_m);

  std::size_t count() const { return faces_.count(); }
  /// Whether particles with their centres in `box` may touch solid k.
  bool near(std::size_t k, const Eigen::AlignedBox3d& box) const;
  /// Whether a particle at x reaches into solid k by more than rounding error.
  bool reached(std::size_t k, const Vec3d& x) const;
  /// Whether solid k is a container.
  bool hollow(std::size_t k) const { return faces_.hollow(k); }
  /// Whether solid k is a container without an opening.
  bool closed(std::size_t k) const { return colliders_[k].shape.closed(); }
  /// Whether x lies inside container k.
  bool holds(std::size_t k, const Vec3d& x) const;

 private:
  Colliders<double> colliders_;
  ColliderFaces faces_;
};

}  // namespace ice_ice_baby
