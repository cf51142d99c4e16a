// Points in cells of a grid, for the question whether a place is taken.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "base/cell_key.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Grid of points with cells as wide as the distance that points must keep.
class PointGrid {
 public:
  explicit PointGrid(double edge_m) : edge_m_(edge_m) {}

  /// @param block number that blockNear returns
  void add(const Vec3d& x, std::size_t block) {
    cells_.emplace(keyAt(x, {0, 0, 0}), Entry{x, block});
  }

  /// Lowest block of a point closer to x than `distance_m`, which is at most a cell, or `none`.
  std::size_t blockNear(const Vec3d& x, double distance_m, std::size_t none) const {
    std::size_t found = none;
    forEachNear(x, distance_m, [&](std::size_t block) {
      if (found == none || block < found) found = block;
    });
    return found;
  }

  /// Calls visit(block) for every point closer to x than `distance_m`, which is at most a cell.
  template <class Visit>
  void forEachNear(const Vec3d& x, double distance_m, const Visit& visit) const {
    for (int k = 0; k < 27; ++k) {
      const auto range = cells_.equal_range(keyAt(x, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1}));
      for (auto entry = range.first; entry != range.second; ++entry) {
        if ((entry->second.x - x).squaredNorm() < distance_m * distance_m) {
          visit(entry->second.block);
        }
      }
    }
  }

 private:
  struct Entry {
    Vec3d x;
    std::size_t block;
  };

  /// Cells with the same key are distinguished by the distances of their points.
  std::uint64_t keyAt(const Vec3d& x, const Eigen::Array<std::int64_t, 3, 1>& beside) const {
    const Eigen::Array<std::int64_t, 3, 1> cell =
        (x.array() / edge_m_).floor().cast<std::int64_t>() + beside;
    return cellKey(cell.x(), cell.y(), cell.z());
  }

  double edge_m_;
  std::unordered_multimap<std::uint64_t, Entry> cells_;
};

}  // namespace ice_ice_baby
