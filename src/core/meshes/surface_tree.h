// A tree of boxes around triangles that finds the closest one and those that a ray meets.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "ice_ice_baby/triangle_mesh.h"
#include "meshes/triangle.h"

namespace ice_ice_baby {

/// Point of a surface closest to another point.
struct SurfacePoint {
  Vec3d point = Vec3d::Zero();
  double distance_m = std::numeric_limits<double>::infinity();
  Index triangle = kNone;  ///< kNone: nothing is near enough
  TrianglePart part = TrianglePart::kFace;
  Vec3d along = Vec3d::Zero();  ///< direction of the edge, if it lies on one

  bool found() const { return triangle != kNone; }
};

/// A triangle and what its distance from a place is at least.
struct NearTriangle {
  Index triangle;
  float distance_m;
};

/// By distance.
struct NearTriangleList {
  const NearTriangle* first;
  const NearTriangle* last;

  const NearTriangle* begin() const { return first; }
  const NearTriangle* end() const { return last; }
  bool empty() const { return first == last; }
};

/// How often a segment passes a surface.
struct Passed {
  bool odd = false;
  bool certain = true;  ///< false: it meets an edge, or ends on the surface
};

/// All answers are in double precision and independent of the order in which they are asked for.
class SurfaceTree {
 public:
  explicit SurfaceTree(const TriangleMesh& mesh);

  std::size_t count() const { return triangles_.size(); }
  /// @param k number of the triangle in the mesh
  const Triangle& triangle(Index k) const { return triangles_[k]; }
  const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

  /// Closest point at most `reach_m` away. Of several equally close triangles, the first.
  /// @param hint a triangle that is probably close, or kNone; affects time only
  SurfacePoint closest(const Vec3d& x, double reach_m, Index hint = kNone) const;
  /// The same, of a list that has the closest triangle.
  /// @param away_m distance of x from the place that the distances of the list are for
  SurfacePoint closestOf(const NearTriangleList& list, const Vec3d& x, double away_m,
                         double reach_m) const;

  /// Calls visit(triangle, distance) for every triangle at most `reach_m` away, until it answers
  /// false. @return whether it never did
  template <class Visit>
  bool within(const Vec3d& x, double reach_m, const Visit& visit) const;

  /// Whether a segment meets the surface.
  bool crosses(const Vec3d& from, const Vec3d& to) const;
  /// Distance to the first place at which a ray meets the surface beyond `skip_m`; infinite if it
  /// meets none within `reach_m`.
  /// @param direction of unit length
  double firstHit(const Vec3d& origin, const Vec3d& direction, double skip_m, double reach_m) const;
  /// @param list has every triangle that the segment may meet
  Passed passed(const NearTriangleList& list, const Vec3d& from, const Vec3d& to) const;
  /// Whether a point lies inside a closed surface.
  bool encloses(const Vec3d& point) const;

  std::size_t bytes() const;

 private:
  std::size_t countHits(const Vec3d& origin, const Vec3d& direction) const;

  struct Node {
    Eigen::AlignedBox3d box;
    Index first;     ///< of the triangles of a leaf; else its second child, the first follows it
    Index leaf = 0;  ///< number of triangles; 0: not a leaf
  };

  /// Splitting at the median, a tree over all possible triangles is at most this deep.
  static constexpr std::size_t kMaxDepth = 64;
  /// Nodes still to visit.
  struct Stack {
    std::array<Index, kMaxDepth> nodes;
    std::size_t count = 0;

    void push(Index node) { nodes[count++] = node; }
    Index pop() { return nodes[--count]; }
  };

  Index build(Index first, Index last);
  template <class Visit>
  void forEachOnRay(const Vec3d& origin, const Vec3d& direction, const double& reach,
                    const Visit& visit) const;

  std::vector<Triangle> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

template <class Visit>
bool SurfaceTree::within(const Vec3d& x, double reach_m, const Visit& visit) const {
  Stack stack;
  stack.push(0);
  while (stack.count > 0) {
    const Index number = stack.pop();
    const Node& node = nodes_[number];
    if (node.box.squaredExteriorDistance(x) > reach_m * reach_m) continue;
    if (node.leaf == 0) {
      stack.push(node.first);
      stack.push(number + 1);
      continue;
    }
    for (Index k = node.first; k < node.first + node.leaf; ++k) {
      const double distance = (closestPoint(triangles_[order_[k]], x).point - x).norm();
      if (distance <= reach_m && !visit(order_[k], distance)) return false;
    }
  }
  return true;
}

}  // namespace ice_ice_baby
