// Axis-aligned boxes in the frame of a collider, the parts of containers and plates.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

template <class Real>
struct AlignedBox {
  Vec3<Real> low;
  Vec3<Real> high;

  bool holds(const Vec3<Real>& point) const {
    return (point.array() > low.array()).all() && (point.array() < high.array()).all();
  }
  /// Whether both ends of a path lie inside the box, farther than `margin` from its sides.
  std::uint32_t holdsPath(const Vec3<Real>& from, const Vec3<Real>& to, Real margin) const {
    std::uint32_t inside = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Real min = low[axis] + margin, max = high[axis] - margin;
      inside &= std::uint32_t(from[axis] > min) & std::uint32_t(to[axis] > min) &
                std::uint32_t(from[axis] < max) & std::uint32_t(to[axis] < max);
    }
    return inside;
  }
  /// Whether both ends of a path lie beyond the same side of the box by more than `margin`.
  std::uint32_t isPassedBy(const Vec3<Real>& from, const Vec3<Real>& to, Real margin) const {
    std::uint32_t beyond = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Real min = low[axis] - margin, max = high[axis] + margin;
      beyond |= (std::uint32_t(from[axis] < min) & std::uint32_t(to[axis] < min)) |
                (std::uint32_t(from[axis] > max) & std::uint32_t(to[axis] > max));
    }
    return beyond;
  }
  /// Distance of its farthest corner from the origin.
  double reach() const { return double(low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm()); }

  template <class Other>
  AlignedBox<Other> cast() const {
    return {low.template cast<Other>(), high.template cast<Other>()};
  }
};

/// Keeps a path outside a solid box: it slides along the face through which it would enter.
template <class Real>
Vec3<Real> keepOutside(const AlignedBox<Real>& box, const Vec3<Real>& from, const Vec3<Real>& to);

}  // namespace ice_ice_baby
