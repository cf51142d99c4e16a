// What the pressure of the coarse level does to colliders: its integral over the faces between
// parts of cells that are free and parts that a collider takes from the water.
#pragma once

#include <vector>

#include "coarse/coarse_grids.h"
#include "coarse/coarse_matrix.h"
#include "colliders/wall_load.h"

namespace ice_ice_baby {

template <class Real>
class WallPressure {
 public:
  /// @param mu (nodes) multipliers of the coarse level, <= 0
  /// @param left (grids) sum of mu phi that is left at the surface of the water, m^2, <= 0
  WallPressure(const CoarseGrids<Real>& grids, const Colliders<Real>& colliders,
               const NodeField<Real>& mu, const std::vector<Real>& left)
      : grids_(grids), colliders_(colliders), mu_(mu), left_(left) {}

  void addLoads(std::vector<WallLoad<Real>>& loads) const;

 private:
  struct Slice;
  struct Cell;
  bool load(const CoarseGrid<Real>& grid, const Eigen::Vector3i& at, Cell& cell) const;
  bool nearWall(const Cell& cell) const;
  Index takerOf(const Cell& cell, const Vec3<Real>& place) const;
  Real crossing(const Cell& cell, Vec3<Real> place, int axis, std::array<Real, 2> between,
                Index last) const;
  void addFaces(const Cell& cell, int axis, std::vector<WallLoad<Real>>& loads) const;

  const CoarseGrids<Real>& grids_;
  const Colliders<Real>& colliders_;
  const NodeField<Real>& mu_;
  const std::vector<Real>& left_;
};

}  // namespace ice_ice_baby
