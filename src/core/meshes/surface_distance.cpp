#include "meshes/surface_distance.h"

#include <algorithm>

#include "base/parallel.h"

namespace ice_ice_baby {

SurfaceDistance::SurfaceDistance(const SurfaceTree& tree, bool closed, double edge_m, double band_m,
                                 double near_m)
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
  near_ = NearTriangles(distances_.size());
  std::vector<NearTriangles::Block> lists(blocks_.inUse());
  parallelFor(
      blocks_.inUse(), [&](std::size_t k) { measure(tree, closed, near_m, k, lists[k]); }, 1);
  near_.set(lists);
}

/// Distances of a block's nodes and the triangles near them.
void SurfaceDistance::measure(const SurfaceTree& tree, bool closed, double near_m,
                              std::size_t block, NearTriangles::Block& lists) {
  Index hint = kNone;
  bool inside = false;
  double clear_m = 0.0;  // around the previous node
  for (int n = 0; n < int(BlockIndex::kNodes); ++n) {
    constexpr int b = BlockIndex::kBlock;
    const Vec3d place =
        blocks_.place(blocks_.corner(block) + BlockIndex::Node(n % b, n / b % b, n / (b * b)));
    const SurfacePoint near = tree.closest(place, band_m_ + slack_m_, hint);
    hint = near.triangle;
    const std::size_t at = block * BlockIndex::kNodes + std::size_t(n);
    if (near.found()) distances_[at] = static_cast<float>(near.distance_m);
    // No surface lies between nodes that are closer to each other than to the surface.
    const bool follows = n % b > 0 && clear_m > blocks_.edge_m();
    if (closed && !follows) inside = tree.encloses(place);
    clear_m = distances_[at];
    if (inside) distances_[at] = -distances_[at];
    closest_[at] = near.triangle;
    if (near.distance_m <= near_m + slack_m_) {
      lists.add(tree, place, near.distance_m, slack_m_);
    } else {
      lists.addEmpty();
    }
  }
}

/// Beside the surface, by what lies between the point and its node, whose side is known.
bool SurfaceDistance::encloses(const SurfaceTree& tree, const Vec3d& point) const {
  const BlockIndex::Node node = blocks_.nearest(point);
  const Index block = blocks_.blockOf(node);
  if (block == BlockIndex::kAbsent) {
    return blocks_.has(node) && inside_[blocks_.placeAmongAll(node / BlockIndex::kBlock)];
  }
  const auto at = std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node);
  const bool node_inside = distances_[at] < 0;
  if (std::abs(distances_[at]) > slack_m_) return node_inside;
  const NearTriangleList list = near_.at(at);
  if (list.empty() || distances_[at] == 0.0f) return tree.encloses(point);
  const Passed passed = tree.passed(list, blocks_.place(node), point);
  return passed.certain ? node_inside != passed.odd : tree.encloses(point);
}

SurfacePoint SurfaceDistance::closest(const SurfaceTree& tree, const Vec3d& point,
                                      double reach_m) const {
  const BlockIndex::Node node = blocks_.nearest(point);
  const Index block = blocks_.blockOf(node);
  if (block == BlockIndex::kAbsent) return tree.closest(point, reach_m);
  const auto at = std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node);
  const NearTriangleList list = near_.at(at);
  if (list.empty()) return tree.closest(point, reach_m, closest_[at]);
  return tree.closestOf(list, point, (point - blocks_.place(node)).norm(), reach_m);
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
