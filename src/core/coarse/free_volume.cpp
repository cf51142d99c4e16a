#include "coarse/free_volume.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Parts of a cell along each axis where a collider is near.
constexpr int kParts = 4;

/// Integrals of the three splines along an axis over part of a cell, from 0 ... 1.
template <class Real>
std::array<Real, 3> integrals(Real from, Real to) {
  const auto until = [](Real u) {
    const Real v = u - Real(0.5);
    return std::array<Real, 3>{-(1 - u) * (1 - u) * (1 - u) / 6, Real(0.75) * u - v * v * v / 3,
                               u * u * u / 6};
  };
  const auto low = until(from), high = until(to);
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

/// Part of a cell along an axis that lies within 0 ... `high` cells from the origin of its grid.
template <class Real>
std::array<Real, 2> within(int cell, Real high) {
  return {std::clamp(Real(-cell), Real(0), Real(1)),
          std::clamp(high - Real(cell), Real(0), Real(1))};
}

template <class Real>
bool inSolid(const Colliders<Real>& colliders, const Vec3<Real>& point) {
  return std::any_of(colliders.begin(), colliders.end(), [&](const MovingShape<Real>& collider) {
    return collider.shape.solid(collider.motion.from.toLocal(point));
  });
}

}  // namespace

template <class Real>
bool FreeVolume<Real>::movedSince(const Colliders<Real>& colliders) const {
  for (std::size_t k = 0; k < colliders.count(); ++k) {
    const Pose<Real>& pose = colliders[k].motion.from;
    if (k >= poses_.size() || pose.position != poses_[k].position ||
        pose.rotation != poses_[k].rotation) {
      return true;
    }
  }
  return false;
}

template <class Real>
void FreeVolume<Real>::update(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders) {
  if (movedSince(colliders)) boxes_.clear();
  poses_.clear();
  for (const MovingShape<Real>& collider : colliders) poses_.push_back(collider.motion.from);
  boxes_.resize(grids.grids().size());
  volume_.resize(grids.nodeCount());
  for (std::size_t g = 0; g < boxes_.size(); ++g) {
    const CoarseGrid<Real>& grid = grids.grids()[g];
    Box& box = boxes_[g];
    if (grid.low == box.low && grid.cells == box.cells && grid.first_node == box.first_node) {
      continue;
    }
    box = {grid.low, grid.cells, grid.first_node};
    if (!grid.empty()) compute(grids, colliders, grid);
  }
}

template <class Real>
void FreeVolume<Real>::compute(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                               const CoarseGrid<Real>& grid) {
  std::fill_n(volume_.begin() + std::ptrdiff_t(grid.first_node), grid.nodeCount(), Real(0));
  // A cell of the border gives to the nodes of the box too.
  for (int colour = 0; colour < CoarseGrids<Real>::kColours; ++colour) {
    const int planes = (grid.cells.x() + 2 - colour + 2) / 3;
    parallelFor(
        std::size_t(std::max(planes, 0)),
        [&](std::size_t k) {
          const int x = colour - 1 + 3 * int(k);
          for (int y = -1; y <= grid.cells.y(); ++y) {
            for (int z = -1; z <= grid.cells.z(); ++z) addCell(grids, colliders, grid, {x, y, z});
          }
        },
        1);
  }
}

/// @param cell relative to the box
template <class Real>
void FreeVolume<Real>::addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
                               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell) {
  const Eigen::Vector3i at = grid.low + cell;
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
        addPart(grid, cell,
                {integrals(px[0], px[1]), integrals(py[0], py[1]), integrals(pz[0], pz[1])},
                particles);
      }
    }
  }
}

/// Adds a part of a cell to the nodes around it that the box has.
/// @param splines integrals over the part along each axis
/// @param particles in a whole cell
template <class Real>
void FreeVolume<Real>::addPart(const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell,
                               const std::array<std::array<Real, 3>, 3>& splines, Real particles) {
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const std::size_t i = a / 9, j = a / 3 % 3, k = a % 3;
    const Eigen::Vector3i node = cell + Eigen::Vector3i(int(i), int(j), int(k));
    if ((node.array() < 0).any() || (node.array() >= grid.nodes().array()).any()) continue;
    const std::ptrdiff_t number = node.x() * grid.strideX() + node.y() * grid.strideY() + node.z();
    volume_[grid.first_node + std::size_t(number)] +=
        particles * splines[0][i] * splines[1][j] * splines[2][k];
  }
}

template class FreeVolume<float>;
template class FreeVolume<double>;

}  // namespace ice_ice_baby
