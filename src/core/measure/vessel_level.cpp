#include "measure/vessel_level.h"

#include <algorithm>
#include <cmath>

#include "measure/vessel_cells.h"

namespace ice_ice_baby {

namespace {

constexpr int kHalvings = 30;
/// Cells along an axis of a vessel that is empty but for water, and of any other.
constexpr int kFew = 12, kMany = 24;

/// Volume of the cells below a height, in cells. Each is spread evenly over the height that it has.
double cellsBelow(const std::vector<double>& heights_m, double height_m, double spread_m) {
  double below = 0.0;
  for (const double cell_m : heights_m) {
    below += std::clamp((height_m - cell_m) / spread_m + 0.5, 0.0, 1.0);
  }
  return below;
}

}  // namespace

double levelOf_m(const VesselSpace& space, const Vec3d& up, double volume_m3,
                 const std::function<bool(const Vec3d&)>& taken) {
  const VesselCells cells = cellsOf(space, taken ? kMany : kFew);
  const double spread_m = cells.width.cwiseProduct(up).norm();
  std::vector<double> heights_m;
  for (const Vec3d& centre : cells.centre) {
    if (!taken || !taken(centre)) heights_m.push_back(up.dot(centre));
  }
  const double lowest_m = space.lowest_m(up), highest_m = -space.lowest_m(-up);
  const double filled = volume_m3 / space.capacity_m3() * double(cells.centre.size());
  if (filled <= 0.0) return 0.0;
  if (filled >= double(heights_m.size())) return highest_m - lowest_m;
  double below = lowest_m, above = highest_m;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (below + above) / 2;
    (cellsBelow(heights_m, middle, spread_m) < filled ? below : above) = middle;
  }
  return above - lowest_m;
}

}  // namespace ice_ice_baby
