// Spheres.
#pragma once

#include <algorithm>
#include <cmath>

#include "colliders/face_collector.h"
#include "colliders/shape_basis.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Sphere around the origin; `reach` is its radius plus that of a particle.
template <class Real>
struct SphereShape : ShapeBasis<Real> {
  Real reach;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;

  /// Empty for the centre, which has no nearest surface point.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  bool solid(const Vec3<Real>& point) const { return point.norm() < curvatureRadius(); }

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    // The sum of three lengths is an upper bound of the path length.
    const Real bound = reach + margin_m + std::abs(to.x() - from.x()) +
                       std::abs(to.y() - from.y()) + std::abs(to.z() - from.z());
    const Real square = from.x() * from.x() + from.y() * from.y() + from.z() * from.z();
    return std::uint32_t(square > bound * bound);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double) const { return 0; }
  ColliderMesh mesh(const MeshDetail& detail) const;

  Real curvatureRadius() const { return reach - this->radius; }
  bool round() const { return true; }
  Real cut(const Vec3<Real>& from, const Vec3<Real>& to) const;

  template <class Other>
  SphereShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)}, static_cast<Other>(reach)};
  }
};

/// @param radius_m of a particle
template <class Real>
SphereShape<Real> makeShape(const Sphere& sphere, double radius_m);

}  // namespace ice_ice_baby
