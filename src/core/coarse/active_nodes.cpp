// Which nodes of the coarse level carry water: those that are full, or that a substep would
// overfill.
#include <algorithm>
#include <cmath>

#include "coarse/displacement_projection.h"

namespace ice_ice_baby {

namespace {

/// Water inside, and at the surface, may be this much less dense than at rest and still counts as
/// full.
constexpr double kSlack = 0.001, kSurfaceSlack = 0.02;
/// Slow water inside that is denser than this gives way, by this share in a substep.
constexpr double kDense = 0.0002, kRelief = 0.1;
/// At the surface a node counts as full with this much room left: fast and slow water.
constexpr double kFastMargin = 0.05, kSlowMargin = 0.20;
/// A node lies inside if all nodes around it are filled to this share.
constexpr double kInside = 0.7;

}  // namespace

template <class Real>
void DisplacementProjection<Real>::deposit() {
  deposits_.assign(grids_.nodeCount() * kDeposits, Real(0));
  grids_.forEachCell([&](const CoarseGrid<Real>& grid, CellRange cell, std::size_t lowest) {
    std::array<Real, kCellNodes * kDeposits> sums;
    passes_.deposit(sorted_, cell, sums.data());
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      Real* out =
          deposits_.data() + std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a)) * kDeposits;
      for (std::size_t k = 0; k < kDeposits; ++k) out[k] += sums[a * kDeposits + k];
    }
  });
}

/// Nodes that are full, or that this substep would overfill.
/// @param fall displacement by gravity in a substep, cells
template <class Real>
void DisplacementProjection<Real>::findActive(Real fall) {
  active_.clear();
  excess_.clear();
  fill_.clear();
  active_.reserve(grids_.nodeCount());
  excess_.reserve(grids_.nodeCount());
  fill_.reserve(grids_.nodeCount());
  const std::vector<Real>& rest = free_volume_.atNodes();
  const Real fast = static_cast<Real>(kFast_falls) * fall;
  for (std::size_t node = 0; node < grids_.nodeCount(); ++node) {
    const Real flow = deposits_[node * kDeposits], fill = deposits_[node * kDeposits + 1];
    if (!(fill > 0)) continue;
    const Real speed = std::sqrt(deposits_[node * kDeposits + 2] / fill);
    const Real calm = fast > 0 ? std::clamp(2 - speed / fast, Real(0), Real(1)) : Real(0);
    const bool inside = interior(node);
    if (!inside && calm == 0) continue;
    const Real margin =
        static_cast<Real>(kFastMargin) + static_cast<Real>(kSlowMargin - kFastMargin) * calm;
    const Real density = deposits_[node * kDeposits + 3];
    const Real loose = (1 - static_cast<Real>(inside ? kSlack : kSurfaceSlack)) * fill - density;
    const Real room = inside ? loose : std::max(loose, (1 - margin) * rest[node] - fill);
    const Real dense = inside ? density - static_cast<Real>(1 + kDense) * fill : Real(0);
    const Real relief = static_cast<Real>(kRelief) * calm * std::max(Real(0), dense);
    const Real b = std::max(Real(0), room) - flow - relief;
    if (room > 0 && b >= 0) continue;
    active_.push_back(Index(node));
    excess_.push_back(b);
    fill_.push_back(fill);
  }
}

/// Whether all 26 nodes around a node are filled.
template <class Real>
bool DisplacementProjection<Real>::interior(std::size_t node) const {
  const CoarseGrid<Real>& grid = grids_.gridOfNode(node);
  const std::vector<Real>& rest = free_volume_.atNodes();
  const auto full = [&](std::ptrdiff_t offset) {
    const std::ptrdiff_t other = std::ptrdiff_t(node) + offset;
    if (other < 0 || other >= std::ptrdiff_t(rest.size())) return false;
    return deposits_[std::size_t(other) * kDeposits + 1] >=
           static_cast<Real>(kInside) * rest[std::size_t(other)];
  };
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (!full(x * grid.strideX() + y * grid.strideY() + z)) return false;
      }
    }
  }
  return true;
}

template class DisplacementProjection<float>;
template class DisplacementProjection<double>;

}  // namespace ice_ice_baby
