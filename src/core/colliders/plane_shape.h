// Grounds and plates.
#pragma once

#include "colliders/face_collector.h"
#include "colliders/shape_basis.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Ground below z = 0, or a plate; bounds particle centres like ContainerShape.
template <class Real>
struct PlaneShape : ShapeBasis<Real> {
  Real surface;
  bool infinite;
  AlignedBox<Real> plate;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;

  /// The ground or the top of the plate, for a point above it; empty below or beside it.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  std::optional<AlignedBox<Real>> box() const {
    if (infinite) return std::nullopt;
    const Real r = this->radius;
    return AlignedBox<Real>{plate.low.array() + r, plate.high.array() - r};
  }
  bool solid(const Vec3<Real>& point) const {
    return infinite ? point.z() < 0 : box()->holds(point);
  }

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    const Real above = surface + margin_m;
    if (!infinite) return plate.isPassedBy(from, to, margin_m);
    return std::uint32_t(from.z() > above) & std::uint32_t(to.z() > above);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double far_m) const { return infinite ? far_m : plate.reach(); }
  ColliderMesh mesh(const MeshDetail& detail) const;

  template <class Other>
  PlaneShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)},
            static_cast<Other>(surface),
            infinite,
            plate.template cast<Other>()};
  }
};

/// @param radius_m of a particle
template <class Real>
PlaneShape<Real> makeShape(const Plane& plane, double radius_m);

}  // namespace ice_ice_baby
