#include "coarse/coarse_grids.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ice_ice_baby {

namespace {

constexpr std::int32_t kFarthestCell = 1 << 28;

/// Frame of the world's grid: an upright ground lies between two layers of cells.
template <class Real>
Pose<Real> worldFrame(const Scene& scene) {
  Pose<Real> frame;
  for (const Plane& plane : scene.planes) {
    if (!plane.infinite() || plane.rpy_deg.head<2>() != Vec3d::Zero().head<2>()) continue;
    frame.position.z() = static_cast<Real>(plane.position_m.z());
    break;
  }
  return frame;
}

/// std::floor, which is a call of the library where the processor need not have SSE 4.1.
template <class Real>
std::int32_t floorOf(Real value) {
  const auto cut = static_cast<std::int32_t>(value);
  return Real(cut) > value ? cut - 1 : cut;
}

}  // namespace

template <class Real>
CoarseGrids<Real>::CoarseGrids(const Scene& scene, const Colliders<Real>& colliders)
    : cell_m_(static_cast<Real>(kCell_d * scene.fluid.spacing_m)) {
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  const Vec3<Real> unbounded = Vec3<Real>::Constant(kInfinity);
  for (std::size_t k = 0; k < colliders.count(); ++k) {
    if (!colliders[k].shape.hollow()) continue;
    by_size_.push_back(grids_.size());
    grids_.push_back({{Index(k), {}, fittedCell(colliders[k].shape.room()), unbounded}});
  }
  const auto size = [&](std::size_t g) {
    return colliders[grids_[g].region.collider].shape.turningRadius(0.0);
  };
  std::stable_sort(by_size_.begin(), by_size_.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  grids_.push_back({{kNone, worldFrame<Real>(scene), Vec3<Real>::Constant(cell_m_), unbounded}});
}

/// As near to the edge of any cell as a whole number of cells between the walls allows.
template <class Real>
Vec3<Real> CoarseGrids<Real>::fittedCell(const AlignedBox<Real>& room) const {
  Vec3<Real> cell = Vec3<Real>::Constant(cell_m_);
  for (int axis = 0; axis < 3; ++axis) {
    const Real size = room.high[axis] - room.low[axis];
    if (!std::isfinite(size) || !(size > 0)) continue;
    cell[axis] = size / std::max(Real(1), std::round(size / cell_m_));
  }
  return cell;
}

template <class Real>
std::size_t CoarseGrids<Real>::regionAt(const Vec3<Real>& point,
                                        const Colliders<Real>& colliders) const {
  for (const std::size_t g : by_size_) {
    const MovingShape<Real>& container = colliders[grids_[g].region.collider];
    if (container.shape.holds(container.motion.from.toLocal(point))) return g;
  }
  return grids_.size() - 1;
}

template <class Real>
void CoarseGrids<Real>::sort(const VectorField<Real>& position, const Colliders<Real>& colliders) {
  for (CoarseGrid<Real>& grid : grids_) {
    if (grid.region.collider == kNone) continue;
    const MovingShape<Real>& container = colliders[grid.region.collider];
    const AlignedBox<Real> room = container.shape.room();
    grid.region.frame = container.motion.from;
    grid.region.frame.position = container.motion.from.toWorld(room.low);
    grid.region.high_c = (room.high - room.low).cwiseQuotient(grid.region.cell_m);
  }
  locate(position, colliders);
  chooseBoxes(position.size());
  numberCells();
  countingSort();
}

template <class Real>
void CoarseGrids<Real>::locate(const VectorField<Real>& position,
                               const Colliders<Real>& colliders) {
  const std::size_t n = position.size();
  grid_of_.resize(n);
  cell_of_.resize(n);
  for (int axis = 0; axis < 3; ++axis) {
    cell_at_[std::size_t(axis)].resize(n);
    inside_[std::size_t(axis)].resize(n);
  }
  const Real far = static_cast<Real>(kFarthestCell);
  parallelFor(n, [&](std::size_t i) {
    const Vec3<Real> x = position.at(i);
    const std::size_t g = regionAt(x, colliders);
    grid_of_[i] = static_cast<Index>(g);
    const CoarseRegion<Real>& region = grids_[g].region;
    const Vec3<Real> local = region.frame.toLocal(x).cwiseQuotient(region.cell_m);
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = std::size_t(axis);
      // A touch of rounding may put a particle below the floor of its container.
      const std::int32_t at = floorOf(std::clamp(local[axis], -far, far));
      cell_at_[k][i] = at;
      inside_[k][i] = std::clamp(local[axis] - Real(at), Real(0), Real(1));
    }
  });
}

template <class Real>
void CoarseGrids<Real>::numberCells() {
  std::size_t cells = 0, nodes = 0;
  node_padding_ = 0;
  for (auto& planes : planes_) planes.clear();
  for (CoarseGrid<Real>& grid : grids_) {
    if (grid.cells.minCoeff() <= 0) grid.cells.setZero();
    grid.first_cell = cells;
    grid.first_node = nodes;
    if (grid.empty()) continue;
    cells += grid.count();
    nodes += grid.nodeCount();
    const auto reach = std::size_t(2 * (grid.strideX() + grid.strideY() + 1));
    node_padding_ = std::max(node_padding_, reach);
    const auto g = Index(&grid - grids_.data());
    for (int x = 0; x < grid.cells.x(); ++x) planes_[std::size_t(x % kColours)].push_back({g, x});
  }
  node_count_ = nodes;
  start_.assign(cells + 1, 0);
}

template <class Real>
void CoarseGrids<Real>::countingSort() {
  const std::size_t n = grid_of_.size();
  parallelFor(n, [&](std::size_t i) {
    const CoarseGrid<Real>& grid = grids_[grid_of_[i]];
    const Eigen::Vector3i at =
        Eigen::Vector3i(cell_at_[0][i], cell_at_[1][i], cell_at_[2][i]) - grid.low;
    const bool within = (at.array() >= 0).all() && (at.array() < grid.cells.array()).all();
    cell_of_[i] = within ? Index(grid.cell(at.x(), at.y(), at.z())) : kNone;
  });
  std::size_t sorted = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (cell_of_[i] == kNone) continue;
    ++start_[cell_of_[i] + 1];
    ++sorted;
  }
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  order_.resize(sorted);
  for (std::size_t i = n; i-- > 0;) {
    if (cell_of_[i] != kNone) order_[--start_[cell_of_[i] + 1]] = Index(i);
  }
  // Each start moved down to the start of its own cell, one place up.
  std::move(start_.begin() + 1, start_.end(), start_.begin());
  start_.back() = Index(sorted);
}

template <class Real>
void CoarseGrids<Real>::markSupported(const std::vector<char>& supported) {
  supported_.assign(start_.size() - 1, false);
  flood_.clear();
  flood_.reserve(supported_.size());
  const auto visit = [&](Index g, int x, int y, int z) {
    const std::size_t cell = grids_[g].cell(x, y, z);
    if (supported_[cell] || start_[cell + 1] == start_[cell]) return;
    supported_[cell] = true;
    flood_.push_back({std::int32_t(g), x, y, z});
  };
  for (const Index i : order_) {
    if (!supported[i]) continue;
    const Eigen::Vector3i& low = gridOf(i).low;
    visit(grid_of_[i], cell_at_[0][i] - low.x(), cell_at_[1][i] - low.y(),
          cell_at_[2][i] - low.z());
  }
  while (!flood_.empty()) {
    const auto [g, x, y, z] = flood_.back();
    flood_.pop_back();
    const Eigen::Vector3i last = grids_[std::size_t(g)].cells - Eigen::Vector3i::Ones();
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, last.x()); ++i) {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, last.y()); ++j) {
        for (int k = std::max(z - 1, 0); k <= std::min(z + 1, last.z()); ++k) {
          visit(Index(g), i, j, k);
        }
      }
    }
  }
}

template <class Real>
const CoarseGrid<Real>& CoarseGrids<Real>::gridOfNode(std::size_t node) const {
  std::size_t g = grids_.size() - 1;
  while (grids_[g].empty() || grids_[g].first_node > node) --g;
  return grids_[g];
}

/// 7 bits for the grid and 19 for each coordinate; far nodes may share a key, which only makes a
/// guess worse.
template <class Real>
std::uint64_t CoarseGrids<Real>::nodeKey(std::size_t node) const {
  const CoarseGrid<Real>& grid = gridOfNode(node);
  const auto g = std::size_t(&grid - grids_.data());
  const auto local = std::ptrdiff_t(node - grid.first_node);
  const Eigen::Vector3i at =
      grid.low + Eigen::Vector3i(int(local / grid.strideX()),
                                 int(local % grid.strideX() / grid.strideY()),
                                 int(local % grid.strideY()));
  std::uint64_t key = g & 127;
  for (int axis = 0; axis < 3; ++axis) {
    key = key << 19 | (std::uint64_t(at[axis] + (1 << 18)) & ((1 << 19) - 1));
  }
  return key;
}

template <class Real>
std::size_t CoarseGrids<Real>::bytes() const {
  const std::size_t n = grid_of_.capacity();
  return n * (sizeof(Index) + sizeof(Index) + 3 * (sizeof(Real) + sizeof(std::int32_t))) +
         (start_.capacity() + order_.capacity()) * sizeof(Index);
}

template class CoarseGrids<float>;
template class CoarseGrids<double>;

}  // namespace ice_ice_baby
