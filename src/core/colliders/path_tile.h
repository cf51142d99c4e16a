// Many paths side by side, which the compiler makes vectors of.
#pragma once

#include <array>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// So many paths are looked at together.
constexpr std::size_t kClearanceTile = 64;
using ClearMask = std::array<std::uint32_t, kClearanceTile>;

/// Points side by side.
template <class Real>
struct PointTile {
  std::array<Real, kClearanceTile> x, y, z;

  Vec3<Real> at(std::size_t k) const { return {x[k], y[k], z[k]}; }
};

/// Paths in the frame of a shape, and how far they should stay from where it would stop them.
template <class Real>
struct PathTile {
  PointTile<Real> from;
  PointTile<Real> to;
  Real margin_m;
};

}  // namespace ice_ice_baby
