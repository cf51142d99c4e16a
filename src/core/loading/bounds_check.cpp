#include "loading/bounds_check.h"

#include <cmath>

#include "ice_ice_baby/errors.h"
#include "scene/lattice.h"

namespace ice_ice_baby {

namespace {

/// A block may reach this far beyond the bounds, m: rounding error. Centres of its particles lie
/// half a spacing inside it.
constexpr double kHair_m = 1e-6;

/// Rounded to a micrometre.
std::string lengthText(double length_m) { return numberText(std::round(1e6 * length_m) / 1e6); }

void requireVolume(const BoundsParams& bounds) {
  for (int axis = 0; axis < 3; ++axis) {
    if (bounds.min_m[axis] < bounds.max_m[axis]) continue;
    const std::string part = "." + std::to_string(axis);
    throw InvalidInput("bounds.min_m" + part + " = " + numberText(bounds.min_m[axis]) +
                       " must be below bounds.max_m" + part + " = " +
                       numberText(bounds.max_m[axis]));
  }
}

void requireWithin(const BoundsParams& bounds, const Block& block, const std::string& key) {
  const Eigen::AlignedBox3d box = boxAround(block);
  for (int axis = 0; axis < 3; ++axis) {
    const double min_m = bounds.min_m[axis], max_m = bounds.max_m[axis];
    if (box.min()[axis] >= min_m - kHair_m && box.max()[axis] <= max_m + kHair_m) continue;
    const std::string part = "." + std::to_string(axis);
    throw InvalidInput(key + " extends from " + lengthText(box.min()[axis]) + " to " +
                       lengthText(box.max()[axis]) + " m along " + "xyz"[axis] +
                       ", beyond the bounds [" + numberText(min_m) + ", " + numberText(max_m) +
                       "]; move the block, or change bounds.min_m" + part + " or bounds.max_m" +
                       part);
  }
}

}  // namespace

void requireBounds(const Scene& scene) {
  requireVolume(scene.bounds);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    requireWithin(scene.bounds, scene.blocks[k], "blocks." + std::to_string(k));
  }
}

}  // namespace ice_ice_baby
