// Finds paths that no collider can touch, many at a time. Most paths are clear, so the exact
// geometry is only evaluated near walls.
#pragma once

#include <algorithm>

#include "colliders/colliders.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Straight paths of particles: from -> to, or from -> to + by.
template <class Real>
struct Paths {
  const VectorField<Real>& from;
  const VectorField<Real>& to;
  const VectorField<Real>* by = nullptr;
};

/// For particles first ... first + count - 1, whether the path certainly stays farther than
/// `margin_m` from every collider. Conservative: a path that is not clear may still be free.
/// @param count 1 ... kClearanceTile
template <class Real>
ClearMask clearPaths(const Colliders<Real>& colliders, const Paths<Real>& paths, Real margin_m,
                     std::size_t first, std::size_t count);

/// Calls visit(i) for every i of first ... last - 1 whose path is not clear.
template <class Real, class Visit>
void forEachNear(const Colliders<Real>& colliders, const Paths<Real>& paths, Real margin_m,
                 std::size_t first, std::size_t last, const Visit& visit) {
  for (std::size_t i = first; i < last; i += kClearanceTile) {
    const std::size_t count = std::min(kClearanceTile, last - i);
    const ClearMask clear = clearPaths(colliders, paths, margin_m, i, count);
    for (std::size_t k = 0; k < count; ++k) {
      if (!clear[k]) visit(i + k);
    }
  }
}

}  // namespace ice_ice_baby
