// Grounds and plates.
#pragma once

#include "colliders/box_shape.h"

namespace ice_ice_baby {

/// Ground below z = 0, or a plate, which is a box; bounds particle centres like ContainerShape.
template <class Real>
struct PlaneShape : ShapeBasis<Real> {
  Real surface;
  bool infinite;
  BoxShape<Real> plate;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;

  /// The ground for a point above it, empty below; the surfaces of a plate on every side.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  std::optional<AlignedBox<Real>> box() const { return infinite ? std::nullopt : plate.box(); }
  bool solid(const Vec3<Real>& point) const {
    return infinite ? point.z() < 0 : plate.solid(point);
  }

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    const Real above = surface + margin_m;
    if (!infinite) return plate.clear(from, to, margin_m);
    return std::uint32_t(from.z() > above) & std::uint32_t(to.z() > above);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double far_m) const { return infinite ? far_m : plate.turningRadius(far_m); }
  ColliderMesh mesh(const MeshDetail& detail) const;

  template <class Other>
  PlaneShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)},
            static_cast<Other>(surface),
            infinite,
            plate.template cast<Other>()};
  }

 private:
  NearSurfaces<Real> nearGround(const Vec3<Real>& point, Real reach_m) const;
};

/// @param radius_m of a particle
template <class Real>
PlaneShape<Real> makeShape(const Plane& plane, double radius_m);

}  // namespace ice_ice_baby
