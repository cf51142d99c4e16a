#include "solids/solid_points.h"

#include "solids/solid_mass.h"

namespace ice_ice_baby {

Solid filledSolid(const Solid& solid, double spacing_m) {
  if (solid.shape != SolidShape::kCup) return solid;
  const double missing_m = std::max(0.0, spacing_m - solid.wall_m);
  Solid filled = solid;
  filled.wall_m += missing_m;
  filled.radius_m -= missing_m;
  filled.height_m -= missing_m;
  return filled;
}

double filledVolume_m3(const Solid& solid, double spacing_m) {
  return massOf(filledSolid(solid, spacing_m)).volume_m3;
}

double solidCount(const Solid& solid, double spacing_m, double max_count) {
  const double expected = filledVolume_m3(solid, spacing_m) / std::pow(spacing_m, 3);
  if (expected > 4 * max_count) return expected;
  double count = 0.0;
  forEachSolidPoint(solid, spacing_m, [&](const Vec3d&) { ++count; });
  return count;
}

}  // namespace ice_ice_baby
