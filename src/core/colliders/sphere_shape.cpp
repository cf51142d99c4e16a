#include "colliders/sphere_shape.h"

#include "colliders/mesh_parts.h"

namespace ice_ice_baby {

namespace {

/// Point at which a path first touches a sphere around the origin; zero if it does not.
template <class Real>
Vec3<Real> enterBall(Real radius, const Vec3<Real>& from, const Vec3<Real>& to) {
  const Real start = from.norm();
  if (start < Real(1e-6) * radius) return Vec3<Real>(0, 0, radius);
  const Vec3<Real> outside = start < radius ? from * (radius / start) : from;
  const Vec3<Real> path = to - outside;
  const Real a = path.squaredNorm();
  const Real b = outside.dot(path);
  const Real c = outside.squaredNorm() - radius * radius;
  const Real root = b * b - a * c;
  if (a == 0 || b >= 0 || root <= 0) return Vec3<Real>::Zero();
  const Real fraction = std::max(Real(0), (-b - std::sqrt(root)) / a);
  if (fraction > 1) return Vec3<Real>::Zero();
  return (outside + fraction * path).normalized() * radius;
}

}  // namespace

template <class Real>
SphereShape<Real> makeShape(const Sphere& s, double radius_m) {
  return {{static_cast<Real>(radius_m)}, static_cast<Real>(s.radius_m + radius_m)};
}

template <class Real>
Vec3<Real> SphereShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  const Vec3<Real> entry = enterBall(reach, from, to);
  if (entry.isZero()) return to;
  const Vec3<Real> normal = entry / reach;
  const Real distance = to.norm();
  const bool near_side = distance > Real(1e-6) * reach && to.dot(normal) > 0;
  if (distance < reach && near_side) return to * (reach / distance);
  // Through the sphere or beyond its centre: slide along the tangent plane at the point of impact.
  return to + (reach - to.dot(normal)) * normal;
}

template <class Real>
NearSurfaces<Real> SphereShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  const Real distance = point.norm();
  const Real gap = distance - reach;
  if (gap + this->radius >= reach_m || distance == 0) return surfaces;
  const Real ball = curvatureRadius();
  surfaces.add({gap, distance - ball, point / distance, ball / std::max(distance, ball), 0, {}});
  return surfaces;
}

template <class Real>
Real SphereShape<Real>::cut(const Vec3<Real>& from, const Vec3<Real>& to) const {
  const Vec3<Real> way = to - from;
  const Real length2 = way.squaredNorm();
  const Real nearest = length2 > 0 ? -from.dot(way) / length2 : 0;
  if (nearest <= 0 || nearest >= 1) return 0;
  return reach - (from + nearest * way).norm();
}

template <class Real>
void SphereShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  const double distance = path.to.norm();
  if (!path.free()) {
    const Vec3d normal = path.push.normalized();
    faces.add(normal, normal.dot(path.to + path.push));
  } else if (distance > 0) {
    faces.add(path.to / distance, double(reach));
  }
}

template <class Real>
ColliderMesh SphereShape<Real>::mesh(const MeshDetail& detail) const {
  ColliderMesh mesh;
  addEllipsoid(mesh, Vec3d::Constant(double(reach)), detail.round_segments);
  return mesh;
}

template struct SphereShape<float>;
template struct SphereShape<double>;
template SphereShape<float> makeShape<float>(const Sphere&, double);
template SphereShape<double> makeShape<double>(const Sphere&, double);

}  // namespace ice_ice_baby
