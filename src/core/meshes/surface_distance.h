// Lower bounds of the distance from a surface, looked up instead of searched for.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "meshes/block_index.h"
#include "meshes/surface_tree.h"

namespace ice_ice_baby {

/// Distances at the nodes of a lattice near the surface, below 0 inside a closed one.
class SurfaceDistance {
 public:
  /// @param closed whether the surface encloses a solid
  /// @param edge_m distance of the nodes
  /// @param band_m distance from the surface up to which there are nodes
  SurfaceDistance(const SurfaceTree& tree, bool closed, double edge_m, double band_m);

  /// What the distance of a point from the surface is at least, m; at most about `band_m`.
  template <class Real>
  Real atLeast(const Vec3<Real>& point) const {
    const BlockIndex::Node node = blocks_.nearest(point);
    const Index block = blocks_.blockOf(node);
    if (block == BlockIndex::kAbsent) return static_cast<Real>(band_m_);
    const auto at = std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node);
    return std::abs(static_cast<Real>(distances_[at])) - static_cast<Real>(slack_m_);
  }
  /// Whether a point is certainly inside: 1, certainly outside: 0, or the lattice cannot tell: -1.
  int inside(const Vec3d& point) const {
    const BlockIndex::Node node = blocks_.nearest(point);
    const Index block = blocks_.blockOf(node);
    if (block == BlockIndex::kAbsent) {
      return blocks_.has(node) && inside_[blocks_.placeAmongAll(node / BlockIndex::kBlock)];
    }
    const double distance =
        distances_[std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node)];
    return std::abs(distance) < slack_m_ ? -1 : int(distance < 0);
  }
  /// A triangle that is close to a point near the surface, else kNone.
  Index hint(const Vec3d& point) const {
    const BlockIndex::Node node = blocks_.nearest(point);
    const Index block = blocks_.blockOf(node);
    if (block == BlockIndex::kAbsent) return kNone;
    return closest_[std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node)];
  }

  std::size_t bytes() const {
    return blocks_.bytes() + distances_.capacity() * sizeof(float) +
           closest_.capacity() * sizeof(Index) + inside_.capacity();
  }

 private:
  void findSides(const SurfaceTree& tree);
  bool inside(const SurfaceTree& tree, const BlockIndex::Node& block) const;

  BlockIndex blocks_;
  double band_m_;
  double slack_m_;  ///< distance of the corners of a cell from its node, and rounding
  std::vector<float> distances_;
  std::vector<Index> closest_;
  std::vector<std::uint8_t> inside_;  ///< (all blocks) 1: not in use and inside the solid
};

}  // namespace ice_ice_baby
