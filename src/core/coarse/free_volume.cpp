#include "coarse/free_volume.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Parts of a cell along each axis where a collider is near.
constexpr int kParts = 4;

/// The lowest node of a cell has its number.
Eigen::Vector3i nodeOfCell(std::size_t a) { return {int(a / 9), int(a / 3 % 3), int(a % 3)}; }

}  // namespace

/// Finds the colliders that take room from the box, or may.
template <class Real>
void FreeVolume<Real>::findNear(const CoarseGrid<Real>& grid, const Colliders<Real>& colliders) {
  near_.clear();
  const Pose<Real>& frame = grid.region.frame;
  const Vec3<Real> half =
      (grid.cells.template cast<Real>() / 2 + Vec3<Real>::Ones()).cwiseProduct(grid.region.cell_m);
  const Vec3<Real> middle =
      frame.toWorld((grid.low.template cast<Real>() + grid.cells.template cast<Real>() / 2)
                        .cwiseProduct(grid.region.cell_m));
  for (std::size_t k = 0; k < colliders.count(); ++k) {
    if (Index(k) == grid.region.collider) continue;
    const auto& shape = colliders[k].shape;
    const Pose<Real>& pose = colliders[k].motion.from;
    const Vec3<Real> local = pose.toLocal(middle);
    const bool far = shape.clear(local, local, half.norm() + shape.particleRadius());
    if (far && !(shape.hollow() && shape.holds(local))) continue;
    near_.push_back(
        {Index(k), {frame.toLocal(pose.position), frame.rotation.transpose() * pose.rotation}});
  }
}

template <class Real>
void FreeVolume<Real>::update(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders) {
  bool changed = volume_.size() != grids.nodeCount() || boxes_.size() != grids.grids().size();
  boxes_.resize(grids.grids().size());
  for (std::size_t g = 0; g < boxes_.size(); ++g) {
    const CoarseGrid<Real>& grid = grids.grids()[g];
    Box& box = boxes_[g];
    findNear(grid, colliders);
    const bool moved = near_ != box.near;
    if (!moved && grid.low == box.low && grid.cells == box.cells) continue;
    changed = true;
    std::swap(box, known_);
    if (moved) known_.cells.setZero();
    box.low = grid.low;
    box.cells = grid.cells;
    box.near = near_;
    compute(grids, colliders, grid, known_, box);
  }
  if (!changed) return;
  volume_.resize(grids.nodeCount());
  for (std::size_t g = 0; g < boxes_.size(); ++g) {
    std::copy(boxes_[g].volume.begin(), boxes_[g].volume.end(),
              volume_.begin() + std::ptrdiff_t(grids.grids()[g].first_node));
  }
}

/// Nodes that `known` has are copied. The order of a node's sum does not depend on the box.
template <class Real>
void FreeVolume<Real>::compute(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                               const CoarseGrid<Real>& grid, const Box& known, Box& box) const {
  box.volume.assign(grid.empty() ? 0 : grid.nodeCount(), Real(0));
  if (grid.empty()) return;
  const Eigen::Vector3i nodes = grid.nodes();
  parallelFor(std::size_t(nodes.x()), [&](std::size_t x) {
    for (int y = 0; y < nodes.y(); ++y) {
      for (int z = 0; z < nodes.z(); ++z) {
        const Eigen::Vector3i node(int(x), y, z), at = node + box.low;
        if (box.keeps(known, at, at))
          box.volume[box.place(node)] = known.volume[known.place(at - known.low)];
      }
    }
  });
  // A cell of the border gives to the nodes of the box too. Every third plane has nodes of its own.
  for (int colour = 0; colour < CoarseGrids<Real>::kColours; ++colour) {
    const int first = -1 + ((colour - (box.low.x() - 1)) % 3 + 3) % 3;
    const int planes = std::max(0, (box.cells.x() - first + 3) / 3);
    parallelFor(
        std::size_t(planes),
        [&](std::size_t k) {
          const int x = first + 3 * int(k);
          for (int y = -1; y <= box.cells.y(); ++y) {
            for (int z = -1; z <= box.cells.z(); ++z) {
              addCell(grids, colliders, grid, {x, y, z}, known, box);
            }
          }
        },
        1);
  }
}

/// Nodes of a cell that are in the box and not yet known.
template <class Real>
std::array<bool, kCellNodes> FreeVolume<Real>::wantedNodes(const CoarseGrid<Real>& grid,
                                                           const Eigen::Vector3i& cell,
                                                           const Box& known, const Box& box) const {
  std::array<bool, kCellNodes> wanted;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Eigen::Vector3i node = cell + nodeOfCell(a), at = node + grid.low;
    wanted[a] = (node.array() >= 0).all() && (node.array() < grid.nodes().array()).all() &&
                !box.keeps(known, at, at);
  }
  return wanted;
}

/// Finds the colliders whose surface may be within `reach` of a point.
/// @returns nothing if the point is inside the solid of another one
template <class Real>
std::optional<NearCell> FreeVolume<Real>::nearTo(const Colliders<Real>& colliders, const Box& box,
                                                 const Vec3<Real>& point, Real reach) const {
  NearCell near;
  for (std::size_t n = 0; n < box.near.size(); ++n) {
    const MovingShape<Real>& collider = colliders[box.near[n].collider];
    const Vec3<Real> local = collider.motion.from.toLocal(point);
    if (!collider.shape.clear(local, local, reach + collider.shape.particleRadius())) {
      near.add(n);
    } else if (collider.shape.solid(local)) {
      return std::nullopt;
    }
  }
  return near;
}

/// Whether water of the grid can be at a point.
template <class Real>
bool FreeVolume<Real>::isFree(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                              const CoarseGrid<Real>& grid, const Box& box, const NearCell& near,
                              const Vec3<Real>& point) const {
  const auto inSolid = [&](Index k) {
    return colliders[k].shape.solid(colliders[k].motion.from.toLocal(point));
  };
  const std::size_t region = grids.regionAt(point, colliders);
  const bool contained = grid.region.collider != kNone;
  // What is above the rim of an open container is free as well.
  const bool above = contained && region + 1 == grids.grids().size();
  if (region != std::size_t(&grid - grids.grids().data()) && !above) return false;
  if (contained && inSolid(grid.region.collider)) return false;
  for (std::size_t n = 0; n < box.near.size(); ++n) {
    if (near.has(n) && inSolid(box.near[n].collider)) return false;
  }
  return true;
}

/// @param cell relative to the box
template <class Real>
void FreeVolume<Real>::addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell,
                               const Box& known, Box& box) const {
  const Eigen::Vector3i at = grid.low + cell;
  if (box.keeps(known, at, at + Eigen::Vector3i::Constant(2))) return;
  const std::array<bool, kCellNodes> wanted = wantedNodes(grid, cell, known, box);
  Vec3<Real> low, high;  // of what is inside the flat walls of a container; else the whole cell
  for (int axis = 0; axis < 3; ++axis) {
    const Real end = grid.region.high_c[axis];
    const bool walled = grid.region.collider != kNone;
    low[axis] = walled ? std::clamp(Real(-at[axis]), Real(0), Real(1)) : Real(0);
    high[axis] = walled ? std::clamp(end - Real(at[axis]), Real(0), Real(1)) : Real(1);
    if (low[axis] >= high[axis]) return;
  }
  const Vec3<Real>& size = grid.region.cell_m;
  const auto toWorld = [&](const Vec3<Real>& place) {
    return grid.region.frame.toWorld(size.cwiseProduct(at.template cast<Real>() + place));
  };
  const Vec3<Real> middle = (low + high) / 2;
  const std::optional<NearCell> near = nearTo(colliders, box, toWorld(middle), size.norm() / 2);
  if (!near) return;
  const int parts = near->any() ? kParts : 1;
  const Vec3<Real> part = (high - low) / Real(parts);
  const Real particles = Real(kCell_d * kCell_d * kCell_d) * size.prod() /
                         (grids.cell_m() * grids.cell_m() * grids.cell_m());
  for (int p = 0; p < parts * parts * parts; ++p) {
    const Eigen::Vector3i number(p / (parts * parts), p / parts % parts, p % parts);
    const Vec3<Real> from = low + part.cwiseProduct(number.template cast<Real>());
    const Vec3<Real> to = from + part;
    if (!isFree(grids, colliders, grid, box, *near, toWorld((from + to) / 2))) continue;
    const std::array<std::array<Real, 3>, 3> along{splineIntegrals(from.x(), to.x()),
                                                   splineIntegrals(from.y(), to.y()),
                                                   splineIntegrals(from.z(), to.z())};
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      if (!wanted[a]) continue;
      box.volume[box.place(cell + nodeOfCell(a))] +=
          particles * along[0][a / 9] * along[1][a / 3 % 3] * along[2][a % 3];
    }
  }
}

template <class Real>
std::size_t FreeVolume<Real>::bytes() const {
  std::size_t bytes = volume_.capacity() * sizeof(Real) + known_.volume.capacity() * sizeof(Real);
  for (const Box& box : boxes_) bytes += box.volume.capacity() * sizeof(Real);
  return bytes;
}

template class FreeVolume<float>;
template class FreeVolume<double>;

}  // namespace ice_ice_baby
