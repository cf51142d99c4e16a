#include "colliders/box_shape.h"

#include "colliders/mesh_parts.h"

namespace ice_ice_baby {

namespace {

/// Number of axes along which a point lies beyond a box: 1 over a face, 2 beside an edge, 3 beside
/// a corner.
template <class Real>
int axesBeyond(const AlignedBox<Real>& box, const Vec3<Real>& point) {
  return int((point.array() < box.low.array() || point.array() > box.high.array()).count());
}

/// The face of a box from which a point is farthest out; for a point inside the nearest face.
template <class Real>
NearSurface<Real> outermostFace(const AlignedBox<Real>& box, const Vec3<Real>& point, Real radius) {
  const Vec3<Real> below = box.low - point, above = point - box.high;
  int axis;
  const Real distance = below.cwiseMax(above).maxCoeff(&axis);
  const bool high = above[axis] > below[axis];
  Vec3<Real> normal = Vec3<Real>::Zero(), resting = normal;
  normal[axis] = high ? Real(1) : Real(-1);
  resting[axis] = high ? box.high[axis] + radius : box.low[axis] - radius;
  return {distance - radius, distance, normal, 1, axis, resting};
}

}  // namespace

template <class Real>
BoxShape<Real> boxBetween(const Vec3d& low_m, const Vec3d& high_m, double radius_m) {
  BoxShape<Real> shape;
  shape.radius = static_cast<Real>(radius_m);
  shape.grown.low = (low_m.array() - radius_m).matrix().template cast<Real>();
  shape.grown.high = (high_m.array() + radius_m).matrix().template cast<Real>();
  return shape;
}

template <class Real>
BoxShape<Real> makeShape(const Box& b, double radius_m) {
  return boxBetween<Real>(-b.size_m / 2, b.size_m / 2, radius_m);
}

template <class Real>
NearSurfaces<Real> BoxShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  const AlignedBox<Real> solid = material();
  if (axesBeyond(solid, point) < 2) {
    const NearSurface<Real> face = outermostFace(solid, point, this->radius);
    if (face.distance < reach_m) surfaces.add(face);
    return surfaces;
  }
  const Vec3<Real> apart = point - point.cwiseMax(solid.low).cwiseMin(solid.high);
  const Real distance = apart.norm();
  if (distance >= reach_m) return surfaces;
  surfaces.add({distance - this->radius, distance, apart / distance, 0, 0, Vec3<Real>::Zero()});
  return surfaces;
}

template <class Real>
void BoxShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  faces.addPush();
  if (path.free()) faces.addFaceBelow(grown.template cast<double>());
}

template <class Real>
ColliderMesh BoxShape<Real>::mesh(const MeshDetail&) const {
  ColliderMesh mesh;
  addBox(mesh, grown.template cast<double>(), BoxSides{});
  return mesh;
}

template struct BoxShape<float>;
template struct BoxShape<double>;
template BoxShape<float> boxBetween<float>(const Vec3d&, const Vec3d&, double);
template BoxShape<double> boxBetween<double>(const Vec3d&, const Vec3d&, double);
template BoxShape<float> makeShape<float>(const Box&, double);
template BoxShape<double> makeShape<double>(const Box&, double);

}  // namespace ice_ice_baby
