// How much of the surroundings of each node water can fill: the integral of the node's spline over
// the space outside all solids, in particle volumes.
#pragma once

#include <vector>

#include "coarse/coarse_grids.h"

namespace ice_ice_baby {

template <class Real>
class FreeVolume {
 public:
  /// Follows the grids. Nothing is computed while boxes and colliders stay as they are.
  void update(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders);

  /// (nodes)
  const std::vector<Real>& atNodes() const { return volume_; }
  std::size_t bytes() const { return (volume_.capacity() + boxes_.capacity()) * sizeof(Real); }

 private:
  bool current(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders) const;
  void addCell(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const CoarseGrid<Real>& grid, const Eigen::Vector3i& cell);

  std::vector<Real> volume_;
  std::vector<Eigen::Vector3i> boxes_;  ///< low and cells of each grid
  std::vector<Pose<Real>> poses_;       ///< of each collider
};

}  // namespace ice_ice_baby
