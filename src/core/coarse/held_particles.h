// Particles that walls hold: pressed against a wall, they move with it along its normal, and no
// pressure of the coarse level pushes them through it.
#pragma once

#include <algorithm>
#include <vector>

#include "coarse/coarse_grids.h"

namespace ice_ice_baby {

/// Directions along which a wall that is not aligned with the grid holds a particle.
template <class Real>
struct ObliqueHold {
  Index sorted = 0;  ///< place in the order of the grids
  int count = 0;
  std::array<Vec3<Real>, 3> normal;  ///< orthonormal, in the frame of the grid

  /// Holds along one more direction, unless it is held already.
  void add(const Vec3<Real>& direction);
  /// The part of a vector that is free.
  Vec3<Real> project(Vec3<Real> v) const {
    for (int k = 0; k < count; ++k) v -= v.dot(normal[std::size_t(k)]) * normal[std::size_t(k)];
    return v;
  }
};

/// The first of the holds, in ascending order, whose place in the order is not before `sorted`.
template <class Real>
typename std::vector<ObliqueHold<Real>>::const_iterator firstHold(
    const std::vector<ObliqueHold<Real>>& holds, std::size_t sorted) {
  return std::lower_bound(
      holds.begin(), holds.end(), sorted,
      [](const ObliqueHold<Real>& hold, std::size_t first) { return hold.sorted < first; });
}

/// Gap to a wall, in spacings, below which a particle touches it.
constexpr double kTouch_d = 0.01;

/// What the walls that a particle touches do to it.
template <class Real>
struct Hold {
  Vec3<Real> step;                       ///< displacement after the response of the walls, m
  Vec3<Real> free = Vec3<Real>::Ones();  ///< 0 for held axes of the grid
  ObliqueHold<Real> oblique;
};

/// @param from where the particle starts the substep, m
/// @param step its displacement with gravity, m, in the frame of the grid
/// @param held_m displacement into a wall from which on it holds; below it only ends there
template <class Real>
Hold<Real> holdAtWalls(const Colliders<Real>& colliders, const Pose<Real>& grid, Real spacing_m,
                       const Vec3<Real>& from, const Vec3<Real>& step, Real held_m);

}  // namespace ice_ice_baby
