#include "meshes/surface_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ice_ice_baby {

namespace {

constexpr Index kLeafSize = 4;
/// Three directions along which no sides of made things lie.
const std::array<Vec3d, 3> kOblique{Vec3d(0.5377, 0.6178, 0.5736).normalized(),
                                    Vec3d(-0.6313, 0.3847, 0.6733).normalized(),
                                    Vec3d(0.2909, -0.7673, 0.5714).normalized()};

/// Factor on distances that bound others.
constexpr double kRounding = 1e-12;

/// A segment that meets a triangle this close to an edge, in sizes of the triangle, may meet its
/// neighbour too.
constexpr double kBeside = 1e-6;

/// The closest point of the triangles considered so far; of equally close ones, that of the first.
class ClosestSoFar {
 public:
  ClosestSoFar(const std::vector<Triangle>& triangles, const Vec3d& x, double reach_m)
      : triangles_(triangles), x_(x), square_(reach_m * reach_m) {}

  void consider(Index k) {
    const TrianglePoint near = closestPoint(triangles_[k], x_);
    const double square = (near.point - x_).squaredNorm();
    if (square > square_ || (square == square_ && best_.triangle < k)) return;
    square_ = square;
    best_ = {near.point, 0.0, k, near.part, near.along};
  }
  /// Square of the distance of the closest, m^2; of the reach while there is none.
  double square() const { return square_; }
  SurfacePoint found() {
    if (best_.found()) best_.distance_m = std::sqrt(square_);
    return best_;
  }

 private:
  const std::vector<Triangle>& triangles_;
  const Vec3d& x_;
  double square_;
  SurfacePoint best_;
};

/// Whether a ray meets a box before `reach`.
bool meets(const Eigen::AlignedBox3d& box, const Vec3d& origin, const Vec3d& inverse,
           double reach) {
  double first = 0.0, last = reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - origin[axis]) * inverse[axis];
    const double b = (box.max()[axis] - origin[axis]) * inverse[axis];
    // A ray within the plane of a side gives NaN, which neither comparison takes over.
    if (std::min(a, b) > first) first = std::min(a, b);
    if (std::max(a, b) < last) last = std::max(a, b);
  }
  return first <= last * (1 + 1e-12);
}

}  // namespace

SurfaceTree::SurfaceTree(const TriangleMesh& mesh) : order_(mesh.triangles.size()) {
  for (const auto& corners : mesh.triangles) {
    triangles_.push_back(
        {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
  }
  std::iota(order_.begin(), order_.end(), Index(0));
  nodes_.reserve(triangles_.size());
  build(0, static_cast<Index>(order_.size()));
}

Index SurfaceTree::build(Index first, Index last) {
  const auto number = static_cast<Index>(nodes_.size());
  Node node;
  Eigen::AlignedBox3d centres;
  for (Index k = first; k < last; ++k) {
    const Triangle& t = triangles_[order_[k]];
    node.box.extend(t.a).extend(t.b).extend(t.c);
    centres.extend(t.centre());
  }
  node.first = first;
  nodes_.push_back(node);
  if (last - first <= kLeafSize) {
    nodes_[number].leaf = last - first;
    return number;
  }
  int axis;
  centres.sizes().maxCoeff(&axis);
  const Index middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](Index p, Index q) {
                     const double a = triangles_[p].centre()[axis];
                     const double b = triangles_[q].centre()[axis];
                     return a < b || (a == b && p < q);
                   });
  build(first, middle);
  const Index second = build(middle, last);
  nodes_[number].first = second;
  return number;
}

SurfacePoint SurfaceTree::closest(const Vec3d& x, double reach_m, Index hint) const {
  ClosestSoFar best(triangles_, x, reach_m);
  if (hint != kNone) best.consider(hint);
  Stack stack;
  stack.push(0);
  while (stack.count > 0) {
    const Index number = stack.pop();
    const Node& node = nodes_[number];
    if (node.box.squaredExteriorDistance(x) > best.square()) continue;
    if (node.leaf > 0) {
      for (Index k = node.first; k < node.first + node.leaf; ++k) best.consider(order_[k]);
      continue;
    }
    const Index a = number + 1, b = node.first;
    const bool a_first =
        nodes_[a].box.squaredExteriorDistance(x) <= nodes_[b].box.squaredExteriorDistance(x);
    stack.push(a_first ? b : a);
    stack.push(a_first ? a : b);
  }
  return best.found();
}

SurfacePoint SurfaceTree::closestOf(const NearTriangleList& list, const Vec3d& x, double away_m,
                                    double reach_m) const {
  ClosestSoFar best(triangles_, x, reach_m);
  for (const NearTriangle& near : list) {
    const double at_least = double(near.distance_m) - away_m * (1 + kRounding);
    if (at_least > 0 && at_least * at_least > best.square()) break;
    best.consider(near.triangle);
  }
  return best.found();
}

/// Calls visit(distance) for every triangle that a ray meets before `reach`, which may shrink.
template <class Visit>
void SurfaceTree::forEachOnRay(const Vec3d& origin, const Vec3d& direction, const double& reach,
                               const Visit& visit) const {
  const Vec3d inverse = direction.cwiseInverse();
  Stack stack;
  stack.push(0);
  while (stack.count > 0) {
    const Index number = stack.pop();
    const Node& node = nodes_[number];
    if (!meets(node.box, origin, inverse, reach)) continue;
    if (node.leaf == 0) {
      stack.push(node.first);
      stack.push(number + 1);
      continue;
    }
    for (Index k = node.first; k < node.first + node.leaf; ++k) {
      const auto distance = hit(triangles_[order_[k]], origin, direction);
      if (distance && *distance >= 0 && *distance <= reach) visit(*distance);
    }
  }
}

bool SurfaceTree::crosses(const Vec3d& from, const Vec3d& to) const {
  bool found = false;
  double reach = 1.0;
  forEachOnRay(from, to - from, reach, [&](double) {
    found = true;
    reach = -1.0;
  });
  return found;
}

Passed SurfaceTree::passed(const NearTriangleList& list, const Vec3d& from, const Vec3d& to) const {
  const Vec3d way = to - from;
  const auto meets = [&](Index k, double margin) {
    const auto share = hit(triangles_[k], from, way, margin);
    return share && *share >= -margin && *share <= 1 + margin;
  };
  Passed passed;
  for (const NearTriangle& near : list) {
    if (!meets(near.triangle, kBeside)) continue;
    if (!meets(near.triangle, -kBeside)) passed.certain = false;
    passed.odd = !passed.odd;
  }
  return passed;
}

double SurfaceTree::firstHit(const Vec3d& origin, const Vec3d& direction, double skip_m,
                             double reach_m) const {
  double nearest = std::numeric_limits<double>::infinity(), reach = reach_m;
  forEachOnRay(origin, direction, reach, [&](double distance) {
    if (distance > skip_m) nearest = reach = std::min(reach, distance);
  });
  return nearest;
}

/// By the parity of what three rays meet, of which one may pass through an edge.
bool SurfaceTree::encloses(const Vec3d& point) const {
  if (!bounds().contains(point)) return false;
  int odd = 0;
  for (const Vec3d& direction : kOblique) odd += int(countHits(point, direction) % 2);
  return odd >= 2;
}

std::size_t SurfaceTree::countHits(const Vec3d& origin, const Vec3d& direction) const {
  std::size_t count = 0;
  const double reach = std::numeric_limits<double>::infinity();
  forEachOnRay(origin, direction, reach, [&](double) { ++count; });
  return count;
}

std::size_t SurfaceTree::bytes() const {
  return triangles_.capacity() * sizeof(Triangle) + order_.capacity() * sizeof(Index) +
         nodes_.capacity() * sizeof(Node);
}

}  // namespace ice_ice_baby
