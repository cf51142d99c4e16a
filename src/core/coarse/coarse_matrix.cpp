#include "coarse/coarse_matrix.h"

#include <algorithm>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Place in a row of the matrix of node b, seen from node a of the same cell.
constexpr std::size_t stencilPlace(std::size_t a, std::size_t b) {
  const std::size_t x = b / 9 + 2 - a / 9, y = b / 3 % 3 + 2 - a / 3 % 3, z = b % 3 + 2 - a % 3;
  return (x * 5 + y) * 5 + z;
}

/// Nodes with less water than this lie inside ice. A node in water alone has 0.9.
constexpr double kMinWater = 0.02;

struct PairTables {
  std::array<std::array<std::uint8_t, kCellNodes>, kCellNodes> place, pair;
  PairTables() {
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      for (std::size_t b = 0; b < kCellNodes; ++b) {
        place[a][b] = std::uint8_t(stencilPlace(a, b));
        pair[a][b] =
            std::uint8_t((kPairAlong[a / 9][b / 9] * 6 + kPairAlong[a / 3 % 3][b / 3 % 3]) * 6 +
                         kPairAlong[a % 3][b % 3]);
      }
    }
  }
};

const PairTables kTables;

}  // namespace

template <class Real>
void CoarseMatrix<Real>::assemble(const CoarseGrids<Real>& grids, const CellPasses<Real>& passes,
                                  const CellParticles<Real>& particles,
                                  const std::vector<ObliqueHold<Real>>& oblique,
                                  const std::vector<Index>& active) {
  active_.reserve(grids.nodeCount());
  active_ = active;
  strides_.reserve(grids.nodeCount());
  diagonal_.reserve(grids.nodeCount());
  row_of_.assign(grids.nodeCount(), kNone);
  strides_.resize(active.size());
  // Room to grow, so that water that spreads seldom takes new memory.
  if (max_rows_ < active.size()) {
    const std::size_t likely = std::min(grids.nodeCount(), grids.order().size() / 16 + 64);
    max_rows_ = std::max(2 * active.size(), likely);
    rows_.reserve(max_rows_ * kStencil);
  }
  rows_.assign(active.size() * kStencil, Real(0));
  for (std::size_t row = 0; row < active.size(); ++row) row_of_[active[row]] = Index(row);
  for (const CoarseGrid<Real>& grid : grids.grids()) {
    if (grid.empty()) continue;
    const auto last = grid.first_node + grid.nodeCount();
    for (auto a = std::lower_bound(active.begin(), active.end(), Index(grid.first_node));
         a != active.end() && *a < last; ++a) {
      strides_[std::size_t(a - active.begin())] = {grid.strideX(), grid.strideY()};
    }
  }
  grids.forEachCell([&](const CoarseGrid<Real>& grid, CellRange cell, std::size_t lowest) {
    if (!anyActive(grid, lowest)) return;
    std::array<Real, kCellPairs> pairs;
    passes.normalMatrix(particles, cell, pairs.data());
    addCell(grid, lowest, pairs.data());
    auto hold = firstHold(oblique, cell.first);
    for (; hold != oblique.end() && hold->sorted < cell.first + cell.count; ++hold) {
      addOblique(grid, lowest, particles, *hold);
    }
  });
  diagonal_.resize(active.size());
  for (std::size_t row = 0; row < active.size(); ++row) {
    diagonal_[row] = rows_[row * kStencil + kStencil / 2];
  }
}

template <class Real>
bool CoarseMatrix<Real>::anyActive(const CoarseGrid<Real>& grid, std::size_t lowest) const {
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    if (row_of_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))] != kNone) return true;
  }
  return false;
}

template <class Real>
void CoarseMatrix<Real>::addCell(const CoarseGrid<Real>& grid, std::size_t lowest,
                                 const Real* pairs) {
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Index row = row_of_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))];
    if (row == kNone) continue;
    Real* out = rows_.data() + row * kStencil;
    for (std::size_t b = 0; b < kCellNodes; ++b) {
      out[kTables.place[a][b]] += pairs[kTables.pair[a][b]];
    }
  }
}

/// The part of a particle that is held along directions other than the axes.
template <class Real>
void CoarseMatrix<Real>::addOblique(const CoarseGrid<Real>& grid, std::size_t lowest,
                                    const CellParticles<Real>& particles,
                                    const ObliqueHold<Real>& hold) {
  const std::size_t k = hold.sorted;
  const SplineAt<Real> spline(particles, k);
  const Vec3<Real> scale = scaleOf(particles, k);
  std::array<Vec3<Real>, kCellNodes> slopes;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    slopes[a] = particles.volume[k] * hold.project(spline.slope(a).cwiseProduct(scale));
  }
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Index row = row_of_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))];
    if (row == kNone) continue;
    Real* out = rows_.data() + row * kStencil;
    for (std::size_t b = 0; b < kCellNodes; ++b) {
      out[kTables.place[a][b]] += slopes[a].dot(slopes[b]);
    }
  }
}

template <class Real>
void CoarseMatrix<Real>::addBodies(const IceBodies<Real>* bodies, const Particles<Real>& particles,
                                   double particle_kg, const CoarseGrids<Real>& grids,
                                   const CellParticles<Real>& sorted,
                                   const std::vector<Index>& place, const std::vector<Real>& fill) {
  bodies_.assemble(bodies, particles, particle_kg, grids, sorted, place, row_of_, rows());
  if (!bodies) return;
  bodies_.addDiagonal(diagonal_);
  for (std::size_t row = 0; row < rows(); ++row) {
    const Real water = rows_[row * kStencil + kStencil / 2];
    if (water < static_cast<Real>(kMinWater) * fill[row]) diagonal_[row] = 0;
  }
}

template <class Real>
void CoarseMatrix<Real>::multiply(const NodeField<Real>& x, std::vector<Real>& y) const {
  y.resize(active_.size());
  parallelFor(
      active_.size(),
      [&](std::size_t row) {
        const Real* coefficients = rows_.data() + row * kStencil;
        const auto [stride_x, stride_y] = strides_[row];
        const Real* lowest = x.data() + active_[row] - 2 * (stride_x + stride_y + 1);
        std::array<Real, 5> sums{};
        for (int i = 0; i < 5; ++i) {
          for (int j = 0; j < 5; ++j) {
            const Real* line = lowest + i * stride_x + j * stride_y;
            for (std::size_t k = 0; k < 5; ++k) sums[k] += *coefficients++ * line[k];
          }
        }
        y[row] = ((sums[0] + sums[1]) + (sums[2] + sums[3])) + sums[4];
      },
      64);
  bodies_.addProduct(active_, x.data(), y);
}

template class CoarseMatrix<float>;
template class CoarseMatrix<double>;

}  // namespace ice_ice_baby
