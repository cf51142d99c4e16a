// Solid boxes.
#pragma once

#include "colliders/face_collector.h"
#include "colliders/shape_basis.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Solid box, also the finite plates of PlaneShape; `grown` bounds particle centres.
template <class Real>
struct BoxShape : ShapeBasis<Real> {
  AlignedBox<Real> grown;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
    return keepOutside(grown, from, to);
  }

  /// One surface: over a face that face, beside an edge or a corner the closest point of it, for a
  /// point inside the nearest face.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  AlignedBox<Real> material() const {
    const Real r = this->radius;
    return {grown.low.array() + r, grown.high.array() - r};
  }
  std::optional<AlignedBox<Real>> box() const { return material(); }
  bool solid(const Vec3<Real>& point) const { return material().holds(point); }

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    return grown.isPassedBy(from, to, margin_m);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double) const { return grown.reach(); }
  ColliderMesh mesh(const MeshDetail& detail) const;

  template <class Other>
  BoxShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)}, grown.template cast<Other>()};
  }
};

/// @param low_m, high_m corners of the solid, in its frame
/// @param radius_m of a particle
template <class Real>
BoxShape<Real> boxBetween(const Vec3d& low_m, const Vec3d& high_m, double radius_m);

/// @param radius_m of a particle
template <class Real>
BoxShape<Real> makeShape(const Box& box, double radius_m);

}  // namespace ice_ice_baby
