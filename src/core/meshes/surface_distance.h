// The distance from a surface and its closest point, looked up instead of searched for.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "meshes/block_index.h"
#include "meshes/near_triangles.h"
#include "meshes/surface_tree.h"

namespace ice_ice_baby {

/// Distances at the nodes of a lattice near the surface, below 0 inside a closed one.
class SurfaceDistance {
 public:
  /// @param closed whether the surface encloses a solid
  /// @param edge_m distance of the nodes
  /// @param band_m distance from the surface up to which there are nodes
  /// @param near_m distance from the surface up to which its closest point is found fast
  SurfaceDistance(const SurfaceTree& tree, bool closed, double edge_m, double band_m,
                  double near_m);

  /// What the distance of a point from the surface is at least, m; at most about `band_m`.
  template <class Real>
  Real atLeast(const Vec3<Real>& point) const {
    const BlockIndex::Node node = blocks_.nearest(point);
    const Index block = blocks_.blockOf(node);
    if (block == BlockIndex::kAbsent) return static_cast<Real>(band_m_);
    const auto at = std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node);
    return std::abs(static_cast<Real>(distances_[at])) - static_cast<Real>(slack_m_);
  }
  /// Whether a point lies inside a closed surface, as the tree itself finds it.
  bool encloses(const SurfaceTree& tree, const Vec3d& point) const;
  /// The closest point of the surface, as the tree itself finds it.
  SurfacePoint closest(const SurfaceTree& tree, const Vec3d& point, double reach_m) const;

  std::size_t bytes() const {
    return blocks_.bytes() + distances_.capacity() * sizeof(float) +
           closest_.capacity() * sizeof(Index) + near_.bytes() + inside_.capacity();
  }

 private:
  void measure(const SurfaceTree& tree, bool closed, double near_m, std::size_t block,
               NearTriangles::Block& lists);
  void findSides(const SurfaceTree& tree);
  bool inside(const SurfaceTree& tree, const BlockIndex::Node& block) const;

  BlockIndex blocks_;
  double band_m_;
  double slack_m_;  ///< distance of the corners of a cell from its node, and rounding
  std::vector<float> distances_;
  std::vector<Index> closest_;  ///< a triangle that is close to each node
  NearTriangles near_;
  std::vector<std::uint8_t> inside_;  ///< (all blocks) 1: not in use and inside the solid
};

}  // namespace ice_ice_baby
