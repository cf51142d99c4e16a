// The boxes of cells that hold the water.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coarse/coarse_grids.h"

namespace ice_ice_baby {

namespace {

/// Cells of all boxes together: this many per particle, and some more.
constexpr double kCellsPerParticle = 1.0;
constexpr std::size_t kFreeCells = 4096;

/// The sides of boxes lie at multiples of this many cells, so that they seldom change.
constexpr int kBoxStep = 4;
/// Between walls that are no farther apart a box reaches from wall to wall.
constexpr int kWholeBox = 16;

std::array<int, 2> roundOut(int low, int high) {
  const auto down = [](int at) { return (at - (at < 0 ? kBoxStep - 1 : 0)) / kBoxStep * kBoxStep; };
  return {down(low), down(high) + kBoxStep - 1};
}

}  // namespace

/// The boxes that just hold all particles, or less where these have too many cells.
template <class Real>
void CoarseGrids<Real>::chooseBoxes(std::size_t particles) {
  const Eigen::Vector3i none = Eigen::Vector3i::Constant(std::numeric_limits<int>::max());
  std::vector<Eigen::Vector3i>&low = lowest_, &high = highest_;
  low.assign(grids_.size(), none);
  high.assign(grids_.size(), -none);
  for (std::size_t i = 0; i < particles; ++i) {
    const std::size_t g = grid_of_[i];
    for (int axis = 0; axis < 3; ++axis) {
      const int at = cell_at_[std::size_t(axis)][i];
      low[g][axis] = std::min(low[g][axis], at);
      high[g][axis] = std::max(high[g][axis], at);
    }
  }
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    grids_[g].low.setZero();
    grids_[g].cells.setZero();
    if (low[g].x() > high[g].x()) continue;
    const Vec3<Real>& size = grids_[g].region.high_c;
    for (int axis = 0; axis < 3; ++axis) {
      const bool walled = std::isfinite(size[axis]) && size[axis] <= kWholeBox;
      const auto [first, last] =
          walled ? std::array<int, 2>{0, std::max(0, int(std::ceil(size[axis])) - 1)}
                 : roundOut(low[g][axis], high[g][axis]);
      grids_[g].low[axis] = first;
      grids_[g].cells[axis] = last - first + 1;
    }
  }
  shrink(std::size_t(kCellsPerParticle * double(particles)) + kFreeCells);
}

/// Takes the emptier end off the longest axis of the largest box until all fit.
template <class Real>
void CoarseGrids<Real>::shrink(std::size_t max_cells) {
  const auto volume = [](const CoarseGrid<Real>& grid) {
    return double(grid.cells.x()) * grid.cells.y() * grid.cells.z();
  };
  for (;;) {
    double total = 0.0;
    CoarseGrid<Real>* largest = &grids_.front();
    for (CoarseGrid<Real>& grid : grids_) {
      total += volume(grid);
      if (volume(grid) > volume(*largest)) largest = &grid;
    }
    if (total <= double(max_cells)) return;
    int axis;
    largest->cells.maxCoeff(&axis);
    const int cut = std::max(1, largest->cells[axis] / 4);
    const int low = largest->low[axis], high = low + largest->cells[axis];
    const auto g = Index(largest - grids_.data());
    std::size_t below = 0, above = 0;
    for (std::size_t i = 0; i < grid_of_.size(); ++i) {
      if (grid_of_[i] != g) continue;
      const int at = cell_at_[std::size_t(axis)][i];
      below += at >= low && at < low + cut;
      above += at >= high - cut && at < high;
    }
    largest->cells[axis] -= cut;
    if (below < above) largest->low[axis] += cut;
  }
}

template class CoarseGrids<float>;
template class CoarseGrids<double>;

}  // namespace ice_ice_baby
