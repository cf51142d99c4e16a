// Geometry of single shapes, each in its own frame.
#include <algorithm>
#include <cmath>

#include "colliders/colliders.h"

namespace ice_ice_baby {

namespace {

/// Axis, side and path fraction at which a path enters a box; fraction 2 when it does not.
template <class Real>
struct Entry {
  int axis = 2;
  bool high = true;
  Real fraction = 2;
};

template <class Real>
Entry<Real> enter(const BoxShape<Real>& box, const Vec3<Real>& from, const Vec3<Real>& to) {
  Entry<Real> entry;
  Real enters = -1, leaves = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Real step = to[axis] - from[axis];
    if (step == 0) {
      if (from[axis] <= box.low[axis] || from[axis] >= box.high[axis]) return Entry<Real>();
      continue;
    }
    Real near = (box.low[axis] - from[axis]) / step;
    Real far = (box.high[axis] - from[axis]) / step;
    const bool high = near > far;
    if (high) std::swap(near, far);
    if (near > enters) {
      enters = near;
      entry.axis = axis;
      entry.high = high;
    }
    leaves = std::min(leaves, far);
  }
  if (enters < 0 || enters >= leaves) return Entry<Real>();
  entry.fraction = enters;
  return entry;
}

/// Point on the surface of the box nearest to a point inside it.
template <class Real>
Vec3<Real> pushedOut(const BoxShape<Real>& box, Vec3<Real> point) {
  int axis = 0;
  const Vec3<Real> below = point - box.low;
  const Vec3<Real> above = box.high - point;
  const Vec3<Real> depth = below.cwiseMin(above);
  depth.minCoeff(&axis);
  point[axis] = below[axis] < above[axis] ? box.low[axis] : box.high[axis];
  return point;
}

/// Keeps a path outside a solid box: it slides along the face by which it would enter.
template <class Real>
Vec3<Real> keepOutside(const BoxShape<Real>& box, const Vec3<Real>& from, Vec3<Real> to) {
  const Vec3<Real> start = box.holds(from) ? pushedOut(box, from) : from;
  const Entry<Real> entry = enter(box, start, to);
  if (entry.fraction > 1) return to;
  to[entry.axis] = entry.high ? box.high[entry.axis] : box.low[entry.axis];
  return to;
}

template <class Real>
bool withinSides(const BoxShape<Real>& box, const Vec3<Real>& point) {
  return point.x() >= box.low.x() && point.x() <= box.high.x() && point.y() >= box.low.y() &&
         point.y() <= box.high.y();
}

template <class Real>
Vec3<Real> pathAtHeight(const Vec3<Real>& from, const Vec3<Real>& to, Real z) {
  return from + (to - from) * ((z - from.z()) / (to.z() - from.z()));
}

/// Point at which a path first touches a ball around the origin; zero when it does not.
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

/// Rounding puts what lies on the rim a hair below it: that is neither inside nor outside.
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
  const Real rim = inner.high.z();
  if (onRim(from)) return keepOutside(outer, Vec3<Real>(from.x(), from.y(), rim), to);
  if (middle.holds(from)) {
    const bool leaves =
        open_top && to.z() > rim && withinSides(middle, pathAtHeight(from, to, rim));
    if (leaves) return to;
    Vec3<Real> kept = to.cwiseMax(inner.low).cwiseMin(inner.high);
    // A wall hit below the open mouth stops the sideways motion, not the rise.
    if (open_top) kept.z() = std::max(to.z(), inner.low.z());
    return kept;
  }
  // What comes down on the wall lands on its rim: a jump to its side would be a speed of its own.
  if (open_top && from.z() >= rim && to.z() < rim &&
      withinSides(inner, pathAtHeight(from, to, rim))) {
    return to.cwiseMax(inner.low).cwiseMin(inner.high);
  }
  return keepOutside(outer, from, to);
}

template <class Real>
Vec3<Real> PlaneShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  if (!infinite) return keepOutside(plate, from, to);
  return {to.x(), to.y(), std::max(to.z(), surface)};
}

template <class Real>
Vec3<Real> SphereShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  const Vec3<Real> entry = enterBall(reach, from, to);
  if (entry.isZero()) return to;
  const Vec3<Real> normal = entry / reach;
  const Real distance = to.norm();
  const bool near_side = distance > Real(1e-6) * reach && to.dot(normal) > 0;
  if (distance < reach && near_side) return to * (reach / distance);
  // Through the ball or beyond its middle: slide along the tangent plane where it was hit.
  return to + (reach - to.dot(normal)) * normal;
}

template struct ContainerShape<float>;
template struct ContainerShape<double>;
template struct PlaneShape<float>;
template struct PlaneShape<double>;
template struct SphereShape<float>;
template struct SphereShape<double>;

}  // namespace ice_ice_baby
