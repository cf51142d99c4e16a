#include "colliders/plane_shape.h"

#include <algorithm>

#include "colliders/mesh_parts.h"

namespace ice_ice_baby {

template <class Real>
PlaneShape<Real> makeShape(const Plane& p, double radius_m) {
  PlaneShape<Real> shape;
  shape.radius = static_cast<Real>(radius_m);
  shape.surface = static_cast<Real>(radius_m);
  shape.infinite = p.infinite();
  const Vec3d half(p.size_x_m / 2, p.size_y_m / 2, 0.0);
  shape.plate = boxBetween<Real>(-half - p.thickness_m * Vec3d::UnitZ(), half, radius_m);
  return shape;
}

template <class Real>
Vec3<Real> PlaneShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  if (!infinite) return plate.resolve(from, to);
  return {to.x(), to.y(), std::max(to.z(), surface)};
}

template <class Real>
NearSurfaces<Real> PlaneShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  return infinite ? nearGround(point, reach_m) : plate.near(point, reach_m);
}

template <class Real>
NearSurfaces<Real> PlaneShape<Real>::nearGround(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  const Real gap = point.z() - surface;
  const Real height = gap + this->radius;
  if (height < 0 || height >= reach_m) return surfaces;
  surfaces.add({gap, height, Vec3<Real>::UnitZ(), 1, 2, {0, 0, surface}});
  return surfaces;
}

template <class Real>
void PlaneShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  if (!infinite) return plate.faces(path, faces);
  faces.addAxis(2, double(surface), true);
}

template <class Real>
ColliderMesh PlaneShape<Real>::mesh(const MeshDetail& detail) const {
  ColliderMesh mesh;
  if (infinite) {
    const double half = detail.ground_size_m / 2, top = double(surface);
    addBox(mesh, {{-half, -half, top - detail.ground_depth_m}, {half, half, top}}, BoxSides{});
  } else {
    mesh = plate.mesh(detail);
  }
  mesh.look = Look::kGround;
  mesh.infinite = infinite;
  return mesh;
}

template struct PlaneShape<float>;
template struct PlaneShape<double>;
template PlaneShape<float> makeShape<float>(const Plane&, double);
template PlaneShape<double> makeShape<double>(const Plane&, double);

}  // namespace ice_ice_baby
