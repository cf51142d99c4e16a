// The rigid motion that fits two clouds best, and what it leaves.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Sum over `members` of the squared distance between `after` and the best-fit rigid motion of
/// `before` (Kabsch 1976, by singular values; reflections excluded), m^2.
double squaredRigidMisfit_m2(const std::vector<Vec3d>& before, const std::vector<Vec3d>& after,
                             const std::vector<std::size_t>& members);

/// Groups of the points 0 ... count-1 that chains of pairs join; each group in rising order.
std::vector<std::vector<std::size_t>> connectedGroups(
    std::size_t count, const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

}  // namespace ice_ice_baby
