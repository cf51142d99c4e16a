// A tree of boxes around triangles that finds the closest one and those that a ray meets.
#pragma once

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

  /// Whether a segment meets the surface.
  bool crosses(const Vec3d& from, const Vec3d& to) const;
  /// Distance to the first place at which a ray meets the surface beyond `skip_m`; infinite if it
  /// meets none within `reach_m`.
  /// @param direction of unit length
  double firstHit(const Vec3d& origin, const Vec3d& direction, double skip_m, double reach_m) const;
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

  Index build(Index first, Index last);
  template <class Visit>
  void forEachOnRay(const Vec3d& origin, const Vec3d& direction, const double& reach,
                    const Visit& visit) const;

  std::vector<Triangle> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace ice_ice_baby
