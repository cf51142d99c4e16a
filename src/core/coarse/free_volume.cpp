#include "coarse/free_volume.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Parts of a cell along each axis where a collider is near.
constexpr int kParts = 4;

/// Part of a cell along an axis that lies within 0 ... `high` cells from the origin of its grid.
template <class Real>
std::array<Real, 2> within(int cell, Real high) {
  return {std::clamp(Real(-cell), Real(0), Real(1)),
          std::clamp(high - Real(cell), Real(0), Real(1))};
}

/// The lowest node of a cell has its number.
Eigen::Vector3i nodeOfCell(std::size_t a) { return {int(a / 9), int(a / 3 % 3), int(a % 3)}; }

template <class Real>
bool inSolid(const Colliders<Real>& colliders, const Vec3<Real>& point) {
  return std::any_of(colliders.begin(), colliders.end(), [&](const MovingShape<Real>& collider) {
    return collider.shape.solid(collider.motion.from.toLocal(point));
  });
}

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

/// @param cell relative to the box
template <class Real>
void FreeVolume<Real>::addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell,
                               const Box& known, Box& box) const {
  const Eigen::Vector3i at = grid.low + cell;
  if (box.keeps(known, at, at + Eigen::Vector3i::Constant(2))) return;
  std::array<std::array<Real, 2>, 3> range;
  for (int axis = 0; axis < 3; ++axis) {
    // Outside of a container with flat walls there is nothing; the world goes on.
    range[std::size_t(axis)] = grid.region.collider == kNone
                                   ? std::array<Real, 2>{0, 1}
                                   : within(at[axis], grid.region.high_c[axis]);
    if (range[std::size_t(axis)][0] >= range[std::size_t(axis)][1]) return;
  }
  const Vec3<Real>& size = grid.region.cell_m;
  const auto toWorld = [&](Real x, Real y, Real z) {
    return grid.region.frame.toWorld(
        size.cwiseProduct(at.template cast<Real>() + Vec3<Real>(x, y, z)));
  };
  const Vec3<Real> middle =
      toWorld((range[0][0] + range[0][1]) / 2, (range[1][0] + range[1][1]) / 2,
              (range[2][0] + range[2][1]) / 2);
  const Real reach = size.norm() / 2;
  bool split = false;
  for (std::size_t k = 0; k < colliders.count() && !split; ++k) {
    if (Index(k) == grid.region.collider) continue;
    const Pose<Real>& pose = colliders[k].motion.from;
    const Vec3<Real> local = pose.toLocal(middle);
    split = !colliders[k].shape.clear(local, local, reach + colliders[k].shape.particleRadius());
  }
  const std::size_t g = std::size_t(&grid - grids.grids().data());
  // What is above the rim of an open container is free as well.
  const auto reachable = [&](const Vec3<Real>& point) {
    const std::size_t region = grids.regionAt(point, colliders);
    return region == g || (grid.region.collider != kNone && region + 1 == grids.grids().size());
  };
  if (!split && !reachable(middle)) return;
  const int parts = split ? kParts : 1;
  const auto part = [&](std::size_t axis, int k) {
    const auto [from, to] = range[axis];
    return std::array<Real, 2>{from + (to - from) * Real(k) / Real(parts),
                               from + (to - from) * Real(k + 1) / Real(parts)};
  };
  // Nodes of the cell that are in the box and not yet known.
  std::array<bool, kCellNodes> wanted;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Eigen::Vector3i node = cell + nodeOfCell(a);
    wanted[a] = (node.array() >= 0).all() && (node.array() < grid.nodes().array()).all() &&
                !box.keeps(known, node + grid.low, node + grid.low);
  }
  const Real particles = Real(kCell_d * kCell_d * kCell_d) * size.prod() /
                         (grids.cell_m() * grids.cell_m() * grids.cell_m());
  for (int x = 0; x < parts; ++x) {
    for (int y = 0; y < parts; ++y) {
      for (int z = 0; z < parts; ++z) {
        const auto px = part(0, x), py = part(1, y), pz = part(2, z);
        if (split) {
          const Vec3<Real> point =
              toWorld((px[0] + px[1]) / 2, (py[0] + py[1]) / 2, (pz[0] + pz[1]) / 2);
          if (!reachable(point) || inSolid(colliders, point)) continue;
        }
        const std::array<std::array<Real, 3>, 3> along{splineIntegrals(px[0], px[1]),
                                                       splineIntegrals(py[0], py[1]),
                                                       splineIntegrals(pz[0], pz[1])};
        for (std::size_t a = 0; a < kCellNodes; ++a) {
          if (!wanted[a]) continue;
          box.volume[box.place(cell + nodeOfCell(a))] +=
              particles * along[0][a / 9] * along[1][a / 3 % 3] * along[2][a % 3];
        }
      }
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
