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
  const Vec3d half(p.size_x_m / 2 + radius_m, p.size_y_m / 2 + radius_m, 0.0);
  shape.plate.low = Vec3d(-half.x(), -half.y(), -p.thickness_m - radius_m).template cast<Real>();
  shape.plate.high = Vec3d(half.x(), half.y(), radius_m).template cast<Real>();
  return shape;
}

template <class Real>
Vec3<Real> PlaneShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  if (!infinite) return keepOutside(plate, from, to);
  return {to.x(), to.y(), std::max(to.z(), surface)};
}

template <class Real>
NearSurfaces<Real> PlaneShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  const bool beside = !infinite && ((point.head(2).array() < plate.low.head(2).array()).any() ||
                                    (point.head(2).array() > plate.high.head(2).array()).any());
  const Real gap = point.z() - surface;
  const Real height = gap + this->radius;
  if (beside || height < 0 || height >= reach_m) return surfaces;
  surfaces.add({gap, height, Vec3<Real>::UnitZ(), 1, 2, {0, 0, surface}});
  return surfaces;
}

template <class Real>
void PlaneShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  if (infinite) {
    faces.addAxis(2, double(surface), true);
    return;
  }
  faces.addPush();
  if (path.free()) faces.addFaceBelow(plate.template cast<double>());
}

template <class Real>
ColliderMesh PlaneShape<Real>::mesh(const MeshDetail& detail) const {
  ColliderMesh mesh;
  mesh.look = Look::kGround;
  mesh.infinite = infinite;
  AlignedBox<double> box = plate.template cast<double>();
  if (infinite) {
    const double half = detail.ground_size_m / 2, top = double(surface);
    box = {{-half, -half, top - detail.ground_depth_m}, {half, half, top}};
  }
  addBox(mesh, box, BoxSides{});
  return mesh;
}

template struct PlaneShape<float>;
template struct PlaneShape<double>;
template PlaneShape<float> makeShape<float>(const Plane&, double);
template PlaneShape<double> makeShape<double>(const Plane&, double);

}  // namespace ice_ice_baby
