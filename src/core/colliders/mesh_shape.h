// Solids of any shape, and thin walls, as triangles.
#pragma once

#include <memory>

#include "colliders/face_collector.h"
#include "colliders/shape_basis.h"
#include "ice_ice_baby/collider_mesh.h"
#include "meshes/surface.h"

namespace ice_ice_baby {

/// A surface with two sides: no particle passes it either way. Its measures are those of the scene.
template <class Real>
struct MeshShape : ShapeBasis<Real> {
  std::shared_ptr<const Surface> triangles;
  Look look = Look::kObject;
  bool vessel = false;  ///< whether water in it moves along when it jumps

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;

  /// The closest point.
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const;

  bool solid(const Vec3<Real>& point) const {
    return triangles->encloses(point.template cast<double>());
  }

  std::uint32_t clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    const Real way = (to - from).template lpNorm<1>();  // at least its length
    return std::uint32_t(triangles->atLeast(from) > this->radius + margin_m + way);
  }

  void faces(const PushedPath& path, FaceCollector& faces) const;
  double turningRadius(double) const { return triangles->reach_m(); }
  ColliderMesh mesh(const MeshDetail& detail) const;

  bool holds(const Vec3<Real>& point) const {
    return vessel && triangles->surrounds(point.template cast<double>()) && !solid(point);
  }
  const Surface* triangleSurface() const { return triangles.get(); }

  template <class Other>
  MeshShape<Other> cast() const {
    return {{static_cast<Other>(this->radius)}, triangles, look, vessel};
  }

 private:
  Vec3d outside(const Vec3d& point) const;
};

/// @param radius_m of a particle
template <class Real>
MeshShape<Real> makeShape(const Cylinder& cylinder, double radius_m);
template <class Real>
MeshShape<Real> makeShape(const Capsule& capsule, double radius_m);
template <class Real>
MeshShape<Real> makeShape(const Cup& cup, double radius_m);
/// @throws InvalidInput if the mesh is too large for the spacing
template <class Real>
MeshShape<Real> makeShape(const Mesh& mesh, double radius_m);

}  // namespace ice_ice_baby
