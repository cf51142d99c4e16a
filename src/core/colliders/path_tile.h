// A tile of paths as a structure of arrays, so that the compiler vectorises loops over them.
#pragma once

#include <array>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Number of paths in a tile.
constexpr std::size_t kClearanceTile = 64;
using ClearMask = std::array<std::uint32_t, kClearanceTile>;

/// The points of a tile.
template <class Real>
struct PointTile {
  std::array<Real, kClearanceTile> x, y, z;

  Vec3<Real> at(std::size_t k) const { return {x[k], y[k], z[k]}; }
};

/// The paths of a tile in the frame of a shape, and the distance that they should keep from it.
template <class Real>
struct PathTile {
  PointTile<Real> from;
  PointTile<Real> to;
  Real margin_m;
};

}  // namespace ice_ice_baby
