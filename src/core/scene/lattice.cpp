#include "scene/lattice.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

Eigen::Array<std::int64_t, 3, 1> latticeSize(const Block& block, double spacing_m) {
  const Eigen::Array3d extent = (block.max_m - block.min_m).array() / spacing_m;
  Eigen::Array<std::int64_t, 3, 1> size = (extent + 1e-6).floor().max(0.0).cast<std::int64_t>();
  if (block.sheet) {
    Eigen::Index thinnest = 0;
    extent.minCoeff(&thinnest);
    size[thinnest] = 1;
  }
  return size;
}

LatticeRow latticeRow(const Block& block, double spacing_m,
                      const Eigen::Array<std::int64_t, 3, 1>& size, std::int64_t y,
                      std::int64_t z) {
  if (block.shape == BlockShape::kBox) return {0, size.x()};
  // From the centre, in half widths of the box: there the shape has radius 1.
  const Eigen::Array3d half = (block.max_m - block.min_m).array() / 2;
  const double across = (double(y) + 0.5) * spacing_m / half.y() - 1;
  const double up = (double(z) + 0.5) * spacing_m / half.z() - 1;
  const bool ball = block.shape == BlockShape::kSphere;
  const double rest2 = 1 - across * across - (ball ? up * up : 0.0);
  constexpr double kRim = 1e-6;  // a point on the rim is inside, as latticeSize forgives rounding
  if (rest2 < -kRim) return {};
  const double middle = half.x() / spacing_m - 0.5;
  const double reach = std::sqrt(std::max(rest2, 0.0)) * half.x() / spacing_m + kRim;
  LatticeRow row;
  row.first = std::max(static_cast<std::int64_t>(std::ceil(middle - reach)), std::int64_t(0));
  row.last = std::min(static_cast<std::int64_t>(std::floor(middle + reach)) + 1, size.x());
  row.last = std::max(row.first, row.last);
  return row;
}

// Counting a shape row by row takes time; a shape fills about half of its box.
double latticeCount(const Block& block, double spacing_m, double max_count) {
  const auto size = latticeSize(block, spacing_m);
  const double whole = size.cast<double>().prod();
  if (block.shape == BlockShape::kBox || whole > 4 * max_count) return whole;
  double count = 0.0;
  for (std::int64_t z = 0; z < size.z(); ++z) {
    for (std::int64_t y = 0; y < size.y(); ++y) {
      const LatticeRow row = latticeRow(block, spacing_m, size, y, z);
      count += double(row.last - row.first);
    }
  }
  return count;
}

Eigen::AlignedBox3d boxAround(const Block& block) {
  const Posed pose = poseOf(block.centre_m(), block.rpy_deg);
  const Vec3d half = pose.rotation.cwiseAbs() * (block.max_m - block.min_m) / 2;
  return {block.centre_m() - half, block.centre_m() + half};
}

}  // namespace ice_ice_baby
