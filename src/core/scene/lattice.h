// The cubic lattice on which the particles of a block begin.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Lattice points along the axes of the box of `block` at spacing `spacing_m`.
/// Spawn position of the first is half a spacing inside `min_m`; a sheet is one layer thick.
Eigen::Array<std::int64_t, 3, 1> latticeSize(const Block& block, double spacing_m);

/// Lattice points first ... last - 1 along x.
struct LatticeRow {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// Points of row `y`, `z` of the lattice that lie within the shape of the block, its rim included.
/// @param size latticeSize of the block
LatticeRow latticeRow(const Block& block, double spacing_m,
                      const Eigen::Array<std::int64_t, 3, 1>& size, std::int64_t y, std::int64_t z);

/// Lattice points of one block, as a double because a scene file can ask for more than an integer
/// holds. A shape whose box holds more than four times `max_count` counts as the whole box.
double latticeCount(const Block& block, double spacing_m, double max_count);

/// Axis-aligned box around the box of a block, which may be rotated.
Eigen::AlignedBox3d boxAround(const Block& block);

/// Calls visit(point) for every lattice point of a block, x fastest, then y, then z.
template <class Visit>
void forEachLatticePoint(const Block& block, double spacing_m, const Visit& visit) {
  const auto size = latticeSize(block, spacing_m);
  const bool turned = !block.rpy_deg.isZero();
  const Posed pose = poseOf(block.centre_m(), block.rpy_deg);
  for (std::int64_t z = 0; z < size.z(); ++z) {
    for (std::int64_t y = 0; y < size.y(); ++y) {
      const LatticeRow row = latticeRow(block, spacing_m, size, y, z);
      for (std::int64_t x = row.first; x < row.last; ++x) {
        const Vec3d cell(double(x) + 0.5, double(y) + 0.5, double(z) + 0.5);
        const Vec3d point = block.min_m + spacing_m * cell;
        visit(turned ? pose.toWorld(point - block.centre_m()) : point);
      }
    }
  }
}

}  // namespace ice_ice_baby
