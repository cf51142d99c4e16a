// Containers: boxes that hold water.
#pragma once

#include "colliders/face_collector.h"
#include "colliders/shape_basis.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Container in its own frame: floor of the inner box at z = 0, rim at inner.high.z.
/// `inner` is shrunk and `outer` grown by the particle radius, so both bound particle centres.
/// `middle` lies inside the walls. The side of it on which a centre lies decides to which side of
/// the wall it belongs, even if rounding has moved it slightly into the wall.
template <class Real>
struct ContainerShape : ShapeBasis<Real> {
  AlignedBox<Real> inner;
  AlignedBox<Real> outer;
  AlignedBox<Real> middle;
  bool open_top;

  /// Particles inside stay inside unless they leave through the open top; particles outside stay
  /// outside unless they enter through it.
  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;

  /// Inner walls for a point inside; empty for a point outside.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    return inner.holdsPath(from, to, margin_m) | outer.isPassedBy(from, to, margin_m);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double) const { return outer.reach(); }
  ColliderMesh mesh(const MeshDetail& detail) const;

  bool hollow() const { return true; }
  bool closed() const { return !open_top; }
  bool holds(const Vec3<Real>& point) const { return middle.holds(point); }
  bool solid(const Vec3<Real>& point) const;
  AlignedBox<Real> room() const;
  bool hides(const Vec3<Real>& point, const Vec3<Real>& place, Real slack_m) const;
  std::optional<Rim<Real>> rim(const Vec3<Real>& point, Real reach_m) const;

  template <class Other>
  ContainerShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)},
            inner.template cast<Other>(),
            outer.template cast<Other>(),
            middle.template cast<Other>(),
            open_top};
  }

 private:
  bool onRim(const Vec3<Real>& point) const;
};

/// @param radius_m of a particle
template <class Real>
ContainerShape<Real> makeShape(const Container& container, double radius_m);

}  // namespace ice_ice_baby
