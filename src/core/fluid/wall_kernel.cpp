#include "fluid/wall_kernel.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr int kNodes = 2049;
/// Step of the differences, as a fraction of the reach.
constexpr double kDifference = 1e-3;

}  // namespace

WallKernel::WallKernel(const std::function<double(double)>& half_space, double reach_m)
    : reach_m_(reach_m) {
  const double step = kDifference * reach_m;
  for (int k = 0; k < kNodes; ++k) {
    const double s = reach_m * k / (kNodes - 1);
    // One-sided at the surface: T is not defined inside the wall.
    const double centre = std::max(s, step);
    const double low = half_space(centre - step), high = half_space(centre + step);
    half_space_.push_back(half_space(s));
    curvature_.push_back((low - 2 * half_space(centre) + high) / (step * step));
    slope_.push_back((high - low) / (2 * step) + (s - centre) * curvature_.back());
  }
}

double WallKernel::at(const std::vector<double>& table, double distance_m) const {
  const double place = std::max(distance_m, 0.0) / reach_m_ * (kNodes - 1);
  if (!(place < kNodes - 1)) return 0.0;
  const auto k = static_cast<std::size_t>(place);
  return table[k] + (place - double(k)) * (table[k + 1] - table[k]);
}

double WallKernel::value(double distance_m) const {
  return at(curvature_, distance_m) / (2 * M_PI * distance_m);
}

double WallKernel::beyond(double distance_m) const {
  return (halfSpace(distance_m) - distance_m * slope(distance_m)) / (2 * M_PI);
}

}  // namespace ice_ice_baby
