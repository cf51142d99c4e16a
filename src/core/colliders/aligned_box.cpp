#include "colliders/aligned_box.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Axis, side and path fraction at which a path enters a box; fraction 2 if it does not.
template <class Real>
struct Entry {
  int axis = 2;
  bool high = true;
  Real fraction = 2;
};

template <class Real>
Entry<Real> enter(const AlignedBox<Real>& box, const Vec3<Real>& from, const Vec3<Real>& to) {
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
Vec3<Real> pushedOut(const AlignedBox<Real>& box, Vec3<Real> point) {
  int axis = 0;
  const Vec3<Real> below = point - box.low;
  const Vec3<Real> above = box.high - point;
  const Vec3<Real> depth = below.cwiseMin(above);
  depth.minCoeff(&axis);
  point[axis] = below[axis] < above[axis] ? box.low[axis] : box.high[axis];
  return point;
}

}  // namespace

template <class Real>
Vec3<Real> keepOutside(const AlignedBox<Real>& box, const Vec3<Real>& from, const Vec3<Real>& to) {
  const Vec3<Real> start = box.holds(from) ? pushedOut(box, from) : from;
  const Entry<Real> entry = enter(box, start, to);
  if (entry.fraction > 1) return to;
  Vec3<Real> kept = to;
  kept[entry.axis] = entry.high ? box.high[entry.axis] : box.low[entry.axis];
  return kept;
}

template Vec3<float> keepOutside(const AlignedBox<float>&, const Vec3<float>&, const Vec3<float>&);
template Vec3<double> keepOutside(const AlignedBox<double>&, const Vec3<double>&,
                                  const Vec3<double>&);

}  // namespace ice_ice_baby
