#include "meshes/near_triangles.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Longer lists take no less time than a search.
constexpr std::size_t kMaxListed = 16;

/// Distances in single precision are taken smaller by this share, so that they remain bounds.
constexpr double kRounding = 1e-6;

}  // namespace

/// A triangle that is the closest to a point of the cell is at most two slacks farther from the
/// node than the surface.
void NearTriangles::Block::add(const SurfaceTree& tree, const Vec3d& node, double distance_m,
                               double slack_m) {
  const std::size_t first = triangles.size();
  const double reach = (distance_m + 2 * slack_m) * (1 + kRounding);
  const bool few = tree.within(node, reach, [&](Index k, double distance) {
    triangles.push_back({k, static_cast<float>(distance * (1 - kRounding))});
    return triangles.size() - first <= kMaxListed;
  });
  if (!few) triangles.resize(first);
  std::sort(triangles.begin() + std::ptrdiff_t(first), triangles.end(),
            [](const NearTriangle& a, const NearTriangle& b) {
              return a.distance_m < b.distance_m ||
                     (a.distance_m == b.distance_m && a.triangle < b.triangle);
            });
  counts.push_back(static_cast<std::uint8_t>(triangles.size() - first));
}

void NearTriangles::set(const std::vector<Block>& blocks) {
  std::size_t node = 0, total = 0;
  for (const Block& block : blocks) total += block.triangles.size();
  triangles_.reserve(total);
  for (const Block& block : blocks) {
    for (const std::uint8_t count : block.counts) {
      first_[node + 1] = first_[node] + count;
      ++node;
    }
    triangles_.insert(triangles_.end(), block.triangles.begin(), block.triangles.end());
  }
}

}  // namespace ice_ice_baby
