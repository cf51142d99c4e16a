#include "meshes/surface_distance.h"

#include <algorithm>

#include "base/parallel.h"

namespace ice_ice_baby {

SurfaceDistance::SurfaceDistance(const SurfaceTree& tree, bool closed, double edge_m, double band_m)
    : band_m_(band_m), slack_m_(1.001 * std::sqrt(3.0) / 2 * edge_m) {
  Eigen::AlignedBox3d box = tree.bounds();
  const Vec3d margin = Vec3d::Constant(band_m + 2 * edge_m);
  blocks_ = BlockIndex({box.min() - margin, box.max() + margin}, edge_m);
  blocks_.use([&](const Vec3d& centre, double half_diagonal) {
    return tree.closest(centre, band_m + half_diagonal + slack_m_).found();
  });
  inside_.assign(std::size_t(blocks_.blocks().prod()), 0);
  if (closed) findSides(tree);
  distances_.assign(blocks_.inUse() * BlockIndex::kNodes, static_cast<float>(band_m + slack_m_));
  closest_.assign(distances_.size(), kNone);
  parallelFor(
      blocks_.inUse(),
      [&](std::size_t k) {
        const BlockIndex::Node corner = blocks_.corner(k);
        Index hint = kNone;
        bool inside = false;
        double clear_m = 0.0;  // around the previous node
        for (int n = 0; n < int(BlockIndex::kNodes); ++n) {
          constexpr int b = BlockIndex::kBlock;
          const BlockIndex::Node node = corner + BlockIndex::Node(n % b, n / b % b, n / (b * b));
          const SurfacePoint near = tree.closest(blocks_.place(node), band_m + slack_m_, hint);
          hint = near.triangle;
          const std::size_t at = k * BlockIndex::kNodes + std::size_t(n);
          if (near.found()) distances_[at] = static_cast<float>(near.distance_m);
          // No surface lies between nodes that are closer to each other than to the surface.
          const bool follows = n % b > 0 && clear_m > blocks_.edge_m();
          if (closed && !follows) inside = tree.encloses(blocks_.place(node));
          clear_m = distances_[at];
          if (inside) distances_[at] = -distances_[at];
          closest_[at] = near.triangle;
        }
      },
      1);
}

void SurfaceDistance::findSides(const SurfaceTree& tree) {
  const BlockIndex::Node count = blocks_.blocks();
  for (int z = 0; z < count.z(); ++z) {
    for (int y = 0; y < count.y(); ++y) {
      for (int x = 0; x < count.x(); ++x) {
        const BlockIndex::Node block(x, y, z);
        if (blocks_.uses(block)) continue;
        inside_[blocks_.placeAmongAll(block)] = inside(tree, block);
      }
    }
  }
}

/// No surface lies between two blocks next to each other that are not in use.
bool SurfaceDistance::inside(const SurfaceTree& tree, const BlockIndex::Node& block) const {
  for (int axis = 0; axis < 3; ++axis) {
    const BlockIndex::Node before = block - BlockIndex::Node::Unit(axis);
    if (before[axis] < 0 || blocks_.uses(before)) continue;
    return inside_[blocks_.placeAmongAll(before)] != 0;
  }
  return tree.encloses(blocks_.place(BlockIndex::kBlock * block));
}

}  // namespace ice_ice_baby
