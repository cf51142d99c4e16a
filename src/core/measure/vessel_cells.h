// The inside of a vessel as cells of equal volume.
#pragma once

#include <vector>

#include "measure/vessel_space.h"

namespace ice_ice_baby {

struct VesselCells {
  std::vector<Vec3d> centre;
  /// A uniform distribution of this width along each axis has the variance of a cell, m.
  Vec3d width = Vec3d::Zero();
};

/// @param along number of cells along an axis, even
VesselCells cellsOf(const VesselSpace& space, int along);

}  // namespace ice_ice_baby
