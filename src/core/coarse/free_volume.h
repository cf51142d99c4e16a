// How much of the surroundings of each node water can fill: the integral of the node's spline over
// the space outside all solids, in particle volumes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "coarse/coarse_grids.h"

namespace ice_ice_baby {

/// Some of the colliders near a grid.
class NearCell {
 public:
  void add(std::size_t k) {
    any_ = true;
    if (k < 64) first_ |= std::uint64_t(1) << k;
  }
  bool any() const { return any_; }
  /// Those beyond the first 64 always count as near.
  bool has(std::size_t k) const { return k >= 64 || (first_ >> k & 1) != 0; }

 private:
  bool any_ = false;
  std::uint64_t first_ = 0;
};

template <class Real>
class FreeVolume {
 public:
  /// Follows the grids. Only nodes that are new to the box of a grid are computed, unless a
  /// collider near the box has moved in the frame of the grid.
  void update(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders);

  /// (nodes)
  const std::vector<Real>& atNodes() const { return volume_; }
  std::size_t bytes() const;

 private:
  struct NearCollider {
    Index collider;
    Pose<Real> pose;  ///< in the frame of the grid
    bool operator==(const NearCollider& other) const {
      return collider == other.collider && pose.position == other.pose.position &&
             pose.rotation == other.pose.rotation;
    }
  };
  /// A grid's box and what its volumes were computed for.
  struct Box {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i cells = Eigen::Vector3i::Zero();
    std::vector<NearCollider> near;
    std::vector<Real> volume;  ///< (nodes)

    bool empty() const { return cells.isZero(); }
    std::size_t place(const Eigen::Vector3i& node) const {
      return (std::size_t(node.x()) * std::size_t(cells.y() + 2) + std::size_t(node.y())) *
                 std::size_t(cells.z() + 2) +
             std::size_t(node.z());
    }
    /// Whether it holds the whole room of the nodes from `first` to `last`, counted from the origin
    /// of the grid. Part of the room of its outermost nodes lies beyond the cells that it sums.
    bool has(const Eigen::Vector3i& first, const Eigen::Vector3i& last) const {
      return !empty() && (first.array() > low.array()).all() &&
             (last.array() <= (low + cells).array()).all();
    }
    /// Whether their room is that of the box before.
    bool keeps(const Box& known, const Eigen::Vector3i& first, const Eigen::Vector3i& last) const {
      return known.has(first, last) && has(first, last);
    }
  };
  void findNear(const CoarseGrid<Real>& grid, const Colliders<Real>& colliders);
  void compute(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const CoarseGrid<Real>& grid, const Box& known, Box& box) const;
  std::array<bool, kCellNodes> wantedNodes(const CoarseGrid<Real>& grid,
                                           const Eigen::Vector3i& cell, const Box& known,
                                           const Box& box) const;
  std::optional<NearCell> nearTo(const Colliders<Real>& colliders, const Box& box,
                                 const Vec3<Real>& point, Real reach) const;
  bool isFree(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
              const CoarseGrid<Real>& grid, const Box& box, const NearCell& near,
              const Vec3<Real>& point) const;
  void addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell, const Box& known,
               Box& box) const;

  std::vector<Real> volume_;  ///< (nodes)
  std::vector<Box> boxes_;    ///< (grids)
  std::vector<NearCollider> near_;
  Box known_;  ///< the box that one is computed from
};

}  // namespace ice_ice_baby
