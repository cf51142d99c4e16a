#include "flow/outlet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace ice_ice_baby {

namespace {

/// Sites are this much further apart across the flow than would fill the disc at rest density.
/// Without that, rounding error makes pressure, which pushes the latest layer back to the disc, and
/// each layer that follows makes it worse.
constexpr double kWidened = 1.01;

/// A point of a square lattice in half spacings from the axis, so that distances compare exactly.
struct Site {
  long x, y;

  long square() const { return x * x + y * y; }
  bool operator<(const Site& other) const {
    return std::make_tuple(square(), y, x) < std::make_tuple(other.square(), other.y, other.x);
  }
};

/// The `count` points nearest to the axis.
/// @param odd_x, odd_y whether the axis lies halfway between two columns, and between two rows
std::vector<Site> nearestSites(std::size_t count, bool odd_x, bool odd_y) {
  const long reach = static_cast<long>(std::sqrt(double(count) / M_PI)) + 2;
  std::vector<Site> sites;
  for (long y = -reach; y <= reach; ++y) {
    for (long x = -reach; x <= reach; ++x) sites.push_back({2 * x + odd_x, 2 * y + odd_y});
  }
  std::sort(sites.begin(), sites.end());
  sites.resize(count);
  return sites;
}

double sumOfSquares(const std::vector<Site>& sites) {
  double sum = 0.0;
  for (const Site& site : sites) sum += double(site.square());
  return sum;
}

/// The roundest of the layers whose axis is a point, the middle of an edge or that of a cell.
std::vector<Site> roundLayer(std::size_t count) {
  std::vector<Site> best = nearestSites(count, false, false);
  for (const bool odd_y : {false, true}) {
    std::vector<Site> other = nearestSites(count, true, odd_y);
    if (sumOfSquares(other) < sumOfSquares(best)) best = std::move(other);
  }
  return best;
}

/// Two unit vectors across the direction. They lie along the axes of the scene if that does.
std::array<Vec3d, 2> axesAcross(const Vec3d& direction) {
  Eigen::Index least = 0;
  direction.cwiseAbs().minCoeff(&least);
  const Vec3d beside = Vec3d::Unit(least);
  const Vec3d first = (beside - direction.dot(beside) * direction).normalized();
  return {first, direction.cross(first)};
}

}  // namespace

double siteCount(const Source& source, double spacing_m) {
  return std::max(1.0, std::round(source.area_m2() / (spacing_m * spacing_m)));
}

Posed Source::pose() const {
  const Vec3d along = direction.stableNormalized();
  const auto [across, up] = axesAcross(along);
  Posed pose;
  pose.position = position_m;
  pose.rotation << across, up, along;
  return pose;
}

Outlet::Outlet(const Source& source, double spacing_m) {
  const auto count = static_cast<std::size_t>(siteCount(source, spacing_m));
  // The area of the disc for each site, so that the layers fill the disc whatever its size.
  const double pitch_m = kWidened * std::sqrt(source.area_m2() / double(count));
  for (const Site& site : roundLayer(count)) {
    sites.emplace_back(pitch_m * double(site.x) / 2, pitch_m * double(site.y) / 2, 0.0);
  }
  layer_m3 = double(count) * spacing_m * spacing_m * spacing_m;
}

}  // namespace ice_ice_baby
