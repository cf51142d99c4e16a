#include "meshes/surface.h"

#include <algorithm>
#include <cstdio>

#include "base/recent_results.h"
#include "ice_ice_baby/errors.h"
#include "meshes/mesh_curvature.h"

namespace ice_ice_baby {

namespace {

/// Nodes of the distances and their reach, in particle radii. Nothing asks for more than the
/// support radius, in most scenes four radii. Contact asks for the closest point within one.
constexpr double kEdge_r = 0.5, kBand_r = 4.5, kNear_r = 1.0;

/// Memory of surfaces that may be kept after their scene.
constexpr std::size_t kKept_bytes = 256 << 20;

/// Blocks that a lattice around a surface may have, and area in squared spacings: their tables need
/// 25 kB and a millisecond or two for each of these.
constexpr double kMaxBlocks = 4e6, kMaxArea_d2 = 4e4;

std::string shortText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double areaOf(const SurfaceTree& tree) {
  double area = 0.0;
  for (Index k = 0; k < tree.count(); ++k) area += tree.triangle(k).area();
  return area;
}

void requireSmall(const SurfaceTree& tree, double radius_m) {
  const Vec3d margin = Vec3d::Constant((kBand_r + 2 * kEdge_r) * radius_m);
  const Eigen::AlignedBox3d box(tree.bounds().min() - margin, tree.bounds().max() + margin);
  const double area = areaOf(tree);
  if (BlockIndex::blocksOver(box, kEdge_r * radius_m) <= kMaxBlocks &&
      area <= kMaxArea_d2 * 4 * radius_m * radius_m) {
    return;
  }
  const Vec3d size = tree.bounds().sizes();
  throw InvalidInput(
      "a surface of " + shortText(area) + " m2 in a box of " + shortText(size.x()) + " x " +
      shortText(size.y()) + " x " + shortText(size.z()) + " m is too large for a spacing of " +
      numberText(2 * radius_m) +
      " m; raise fluid.spacing_m, check the scale, or use boxes and planes for what is "
      "large and flat");
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.vertices == b.vertices;
}

}  // namespace

std::shared_ptr<const Surface> Surface::shared(TriangleMesh mesh, double radius_m) {
  static RecentResults<Surface> kept(kKept_bytes);
  return kept.find(
      [&](const Surface& one) { return one.radius_m() == radius_m && same(one.mesh(), mesh); },
      [&] { return std::make_shared<const Surface>(std::move(mesh), radius_m); });
}

Surface::Surface(TriangleMesh mesh, double radius_m)
    : mesh_(std::move(mesh)),
      tree_(mesh_),
      topology_(topologyOf(mesh_)),
      bending_(bendingOf(mesh_)),
      radius_m_(radius_m) {
  for (const Vec3d& vertex : mesh_.vertices) reach_m_ = std::max(reach_m_, vertex.norm());
  if (radius_m == 0.0) return;
  requireSmall(tree_, radius_m);
  distance_.emplace(tree_, topology_.closed(), kEdge_r * radius_m, kBand_r * radius_m,
                    kNear_r * radius_m);
}

bool Surface::encloses(const Vec3d& point) const {
  if (!topology_.closed()) return false;
  return distance_ ? distance_->encloses(tree_, point) : tree_.encloses(point);
}

double Surface::flatness(const SurfacePoint& near, const Vec3d& x) const {
  const Vec3d normal = tree_.triangle(near.triangle).normal().normalized();
  const double along = normal.dot(x - near.point) / near.distance_m;
  // The normals of two facets of a curved surface differ by less than a sharp edge.
  if (std::abs(along) < std::cos(kSharpEdge_deg / 2 * M_PI / 180)) return 0.0;
  const double side = along > 0 ? 1.0 : -1.0;
  return 1 / std::sqrt(std::max(1 + side * bending_[near.triangle] * near.distance_m, 0.1));
}

bool Surface::surrounds(const Vec3d& point) const {
  if (!tree_.bounds().contains(point)) return false;
  const double far = tree_.bounds().diagonal().norm();
  int seen = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      seen += tree_.firstHit(point, side * Vec3d::Unit(axis), 0.0, far) <= far;
    }
  }
  return seen >= 5;
}

std::size_t Surface::bytes() const {
  return mesh_.vertices.capacity() * sizeof(Vec3d) +
         mesh_.triangles.capacity() * sizeof(std::array<Index, 3>) + tree_.bytes() +
         bending_.capacity() * sizeof(double) + (distance_ ? distance_->bytes() : 0);
}

}  // namespace ice_ice_baby
