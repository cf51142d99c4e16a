#include "solids/solid_volumes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/point_grid.h"
#include "particles/kernels.h"
#include "solids/solid_points.h"

namespace ice_ice_baby {

namespace {

/// After so many passes the density is even to half a percent, from 12 % before.
constexpr int kPasses = 6;

struct Pair {
  std::size_t a, b;
  double density;  ///< of one at the other, for a relative volume of 1
};

template <class Kernel>
std::vector<Pair> pairsOf(const std::vector<Vec3d>& points, const Kernel& kernel, double rest) {
  PointGrid grid(kernel.h);
  for (std::size_t k = 0; k < points.size(); ++k) grid.add(points[k], k);
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < points.size(); ++a) {
    const std::size_t first = pairs.size();
    grid.forEachNear(points[a], kernel.h, [&](std::size_t b) {
      if (b <= a) pairs.push_back({a, b, kernel.w((points[a] - points[b]).norm()) / rest});
    });
    // The order within a cell is not specified, but that of a sum has to be.
    std::sort(pairs.begin() + std::ptrdiff_t(first), pairs.end(),
              [](const Pair& p, const Pair& q) { return p.b < q.b; });
  }
  return pairs;
}

}  // namespace

std::vector<double> solidVolumes(const Scene& scene, const Solid& solid) {
  const double d = scene.fluid.spacing_m, h = scene.supportRadius_m();
  std::vector<Vec3d> points;
  forEachSolidPoint(solid, d, [&](const Vec3d& point) { points.push_back(point); });
  const double whole = filledVolume_m3(solid, d) / std::pow(d, 3);
  std::vector<double> volumes(points.size(), whole / double(points.size()));
  if (solid.shape == SolidShape::kBox) return volumes;  // a lattice is even
  const CubicSpline<double> kernel(h);
  const std::vector<Pair> pairs = pairsOf(points, kernel, latticeSum(kernel, d, true));
  std::vector<double> density;
  for (int pass = 0; pass < kPasses; ++pass) {
    density.assign(points.size(), 0.0);
    for (const Pair& pair : pairs) {
      density[pair.a] += pair.density * volumes[pair.b];
      if (pair.a != pair.b) density[pair.b] += pair.density * volumes[pair.a];
    }
    for (std::size_t k = 0; k < points.size(); ++k) volumes[k] /= std::max(1.0, density[k]);
    const double rest = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    for (double& volume : volumes) volume *= whole / rest;
  }
  return volumes;
}

}  // namespace ice_ice_baby
