#include "measure/vessel_cells.h"

#include <cmath>

namespace ice_ice_baby {

namespace {

/// Points of equal weight in a disc about the z axis: centroids of cells of equal area.
std::vector<Vec3d> discPoints(double radius_m, int along) {
  const int rings = along / 2, around = 3 * along / 2;
  std::vector<Vec3d> points;
  const double half_angle = M_PI / around;
  for (int ring = 0; ring < rings; ++ring) {
    const double inner = radius_m * std::sqrt(double(ring) / rings);
    const double outer = radius_m * std::sqrt(double(ring + 1) / rings);
    const double cubes = std::pow(outer, 3) - std::pow(inner, 3);
    const double squares = outer * outer - inner * inner;
    const double centroid = 2.0 / 3.0 * cubes / squares * std::sin(half_angle) / half_angle;
    for (int k = 0; k < around; ++k) {
      const double angle = (2 * k + 1) * half_angle;
      points.emplace_back(centroid * std::cos(angle), centroid * std::sin(angle), 0.0);
    }
  }
  return points;
}

/// Points in the rectangle of a box, at z = 0.
std::vector<Vec3d> rectanglePoints(const Vec3d& low, const Vec3d& step, int along) {
  std::vector<Vec3d> points;
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < along; ++x) {
      points.emplace_back(low.x() + (x + 0.5) * step.x(), low.y() + (y + 0.5) * step.y(), 0.0);
    }
  }
  return points;
}

/// The disc has a variance of radius^2 / 4 along x and y, of which the points have a part.
double widthOfDiscCells_m(const std::vector<Vec3d>& points, double radius_m) {
  double squares = 0.0;
  for (const Vec3d& point : points) squares += point.squaredNorm() / 2;
  return std::sqrt(12 * (radius_m * radius_m / 4 - squares / double(points.size())));
}

}  // namespace

VesselCells cellsOf(const VesselSpace& space, int along) {
  const Vec3d step = (space.high - space.low) / along;
  const std::vector<Vec3d> layer =
      space.round ? discPoints(space.high.x(), along) : rectanglePoints(space.low, step, along);
  VesselCells cells;
  cells.width = step;
  if (space.round) cells.width.head<2>().setConstant(widthOfDiscCells_m(layer, space.high.x()));
  for (int z = 0; z < along; ++z) {
    const double height = space.low.z() + (z + 0.5) * step.z();
    for (const Vec3d& point : layer) cells.centre.push_back(point + height * Vec3d::UnitZ());
  }
  return cells;
}

}  // namespace ice_ice_baby
