// How much of the surroundings of each node water can fill: the integral of the node's spline over
// the space outside all solids, in particle volumes.
#pragma once

#include <vector>

#include "coarse/coarse_grids.h"

namespace ice_ice_baby {

template <class Real>
class FreeVolume {
 public:
  /// Follows the grids. A grid is computed again only when its box or a collider has moved.
  void update(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders);

  /// (nodes)
  const std::vector<Real>& atNodes() const { return volume_; }
  std::size_t bytes() const {
    return volume_.capacity() * sizeof(Real) + boxes_.capacity() * sizeof(Box);
  }

 private:
  /// What the volumes of a grid were computed for.
  struct Box {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i cells = Eigen::Vector3i::Zero();
    std::size_t first_node = 0;
  };
  bool movedSince(const Colliders<Real>& colliders) const;
  void compute(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const CoarseGrid<Real>& grid);
  void addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell);
  void addPart(const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell,
               const std::array<std::array<Real, 3>, 3>& splines, Real particles);

  std::vector<Real> volume_;       ///< (nodes)
  std::vector<Box> boxes_;         ///< (grids)
  std::vector<Pose<Real>> poses_;  ///< of each collider
};

}  // namespace ice_ice_baby
