#include "colliders/container_shape.h"

#include <algorithm>
#include <limits>

#include "colliders/mesh_parts.h"

namespace ice_ice_baby {

namespace {

template <class Real>
bool withinSides(const AlignedBox<Real>& box, const Vec3<Real>& point) {
  return point.x() >= box.low.x() && point.x() <= box.high.x() && point.y() >= box.low.y() &&
         point.y() <= box.high.y();
}

template <class Real>
Vec3<Real> pathAtHeight(const Vec3<Real>& from, const Vec3<Real>& to, Real z) {
  return from + (to - from) * ((z - from.z()) / (to.z() - from.z()));
}

}  // namespace

template <class Real>
ContainerShape<Real> makeShape(const Container& c, double radius_m) {
  const Vec3d half(c.size_m.x() / 2, c.size_m.y() / 2, 0.0);
  const Vec3d high(half.x(), half.y(), c.size_m.z());
  const Vec3d r = Vec3d::Constant(radius_m);
  const Vec3d wall = Vec3d::Constant(c.wall_m);
  ContainerShape<Real> shape;
  shape.radius = static_cast<Real>(radius_m);
  // A box narrower than a particle shrinks to its middle plane.
  shape.inner.low = (-half + r).cwiseMin((high - half) / 2).template cast<Real>();
  shape.inner.high = (high - r).cwiseMax((high - half) / 2).template cast<Real>();
  shape.outer.low = (-half - wall - r).template cast<Real>();
  shape.outer.high = (high + wall + r).template cast<Real>();
  shape.open_top = c.open_top;
  if (c.open_top) {
    shape.inner.high.z() = static_cast<Real>(high.z());
    shape.outer.high.z() = static_cast<Real>(high.z());
  }
  shape.middle = {(shape.inner.low + shape.outer.low) / 2,
                  (shape.inner.high + shape.outer.high) / 2};
  return shape;
}

/// Whether a point inside the wall of an open container is nearer to the rim than to the sides.
/// Rounding puts particles on the rim slightly below it, where they are neither inside nor outside.
template <class Real>
bool ContainerShape<Real>::onRim(const Vec3<Real>& point) const {
  const Real below = inner.high.z() - point.z();
  if (!open_top || below <= 0 || withinSides(inner, point)) return false;
  const Vec3<Real> within_outer = (point - outer.low).cwiseMin(outer.high - point);
  const Vec3<Real> beyond_inner = (inner.low - point).cwiseMax(point - inner.high);
  return below < std::min(within_outer.template head<2>().minCoeff(),
                          beyond_inner.template head<2>().maxCoeff());
}

template <class Real>
Vec3<Real> ContainerShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  const Real rim_z = inner.high.z();
  if (onRim(from)) return keepOutside(outer, Vec3<Real>(from.x(), from.y(), rim_z), to);
  if (middle.holds(from)) {
    const bool leaves =
        open_top && to.z() > rim_z && withinSides(middle, pathAtHeight(from, to, rim_z));
    if (leaves) return to;
    Vec3<Real> kept = to.cwiseMax(inner.low).cwiseMin(inner.high);
    // A wall hit below the open top stops the sideways motion, not the rise.
    if (open_top) kept.z() = std::max(to.z(), inner.low.z());
    return kept;
  }
  // A particle that falls onto the wall lands on its rim; moving it to a side would add velocity.
  if (open_top && from.z() >= rim_z && to.z() < rim_z &&
      withinSides(inner, pathAtHeight(from, to, rim_z))) {
    return to.cwiseMax(inner.low).cwiseMin(inner.high);
  }
  return keepOutside(outer, from, to);
}

template <class Real>
NearSurfaces<Real> ContainerShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  const Vec3<Real> from_low = point - inner.low;
  const Vec3<Real> from_high = inner.high - point;
  const Real nearest = from_low.cwiseMin(from_high).minCoeff();
  if (nearest >= reach_m - this->radius || !holds(point)) return surfaces;
  for (int axis = 0; axis < 3; ++axis) {
    const Real low = from_low[axis] + this->radius;
    const Real high = from_high[axis] + this->radius;
    const Vec3<Real> up = Vec3<Real>::Unit(axis);
    if (low < reach_m) surfaces.add({from_low[axis], low, up, 1, axis, inner.low});
    if (high < reach_m && !(axis == 2 && open_top)) {
      surfaces.add({from_high[axis], high, -up, 1, axis, inner.high});
    }
  }
  return surfaces;
}

template <class Real>
AlignedBox<Real> ContainerShape<Real>::room() const {
  const Vec3<Real> radii = Vec3<Real>::Constant(this->radius);
  AlignedBox<Real> room{inner.low - radii, inner.high + radii};
  if (open_top) room.high.z() = std::numeric_limits<Real>::infinity();
  return room;
}

template <class Real>
bool ContainerShape<Real>::solid(const Vec3<Real>& point) const {
  AlignedBox<Real> around{outer.low.array() + this->radius, outer.high.array() - this->radius};
  if (open_top) around.high.z() = outer.high.z();
  return around.holds(point) && !room().holds(point);
}

template <class Real>
bool ContainerShape<Real>::hides(const Vec3<Real>& point, const Vec3<Real>& place,
                                 Real slack_m) const {
  if (!holds(point)) return false;
  const auto low = inner.low.array() - this->radius - slack_m;
  const auto high = inner.high.array() + this->radius + slack_m;
  return (place.array() < low).any() || (place.array() > high).any();
}

template <class Real>
std::optional<Rim<Real>> ContainerShape<Real>::rim(const Vec3<Real>& point, Real reach_m) const {
  const Real above = point.z() - inner.high.z();
  if (!open_top || above >= reach_m || above <= -reach_m) return std::nullopt;
  Rim<Real> rim{above, point, {}, {}, {}};
  if (above >= 0) rim.below.z() = inner.high.z() - Real(1e-3) * this->radius;
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = std::size_t(axis);
    rim.side[k] = point[axis] < 0 ? Real(-1) : Real(1);
    rim.over[k] = rim.side[k] * point[axis] - inner.high[axis];
    rim.width[k] = middle.high[axis] - inner.high[axis];
  }
  return rim;
}

template <class Real>
void ContainerShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  const auto inside = inner.template cast<double>();
  if (!middle.holds(path.from.template cast<Real>())) {
    faces.addPush();
    if (path.free()) faces.addFaceBelow(outer.template cast<double>());
    return;
  }
  // A particle that leaves through the open top is no longer beside a wall, unless it was pushed
  // back.
  if (open_top && path.to.z() > inside.high.z() && path.free()) return;
  for (int axis = 0; axis < 3; ++axis) {
    faces.addAxis(axis, inside.low[axis], true);
    if (axis < 2 || !open_top) faces.addAxis(axis, inside.high[axis], false);
  }
}

template <class Real>
ColliderMesh ContainerShape<Real>::mesh(const MeshDetail&) const {
  ColliderMesh mesh;
  mesh.look = Look::kGlass;
  const Index within = addBox(mesh, inner.template cast<double>(), BoxSides{true, !open_top});
  const Index without = addBox(mesh, outer.template cast<double>(), BoxSides{false, !open_top});
  addBoxEdges(mesh, within);
  if (open_top) addRing(mesh, within, without);
  return mesh;
}

template struct ContainerShape<float>;
template struct ContainerShape<double>;
template ContainerShape<float> makeShape<float>(const Container&, double);
template ContainerShape<double> makeShape<double>(const Container&, double);

}  // namespace ice_ice_baby
