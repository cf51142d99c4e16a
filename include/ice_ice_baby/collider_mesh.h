// Surfaces of colliders as triangles, for whoever draws them.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

enum class Look { kGlass, kGround, kObject };

/// Closed surface of a solid in the frame of its collider.
struct ColliderMesh {
  std::vector<Vec3d> vertices;                  ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise seen from outside the solid
  std::vector<std::array<Index, 2>> edges;      ///< lines to draw where the surface is see-through
  Look look = Look::kObject;
  bool infinite = false;  ///< the solid goes on beyond what is drawn
  /// Half axes, m, of a whole sphere or ellipsoid about the origin, for viewers that draw one
  /// without its triangles; 0 for any other shape.
  Vec3d half_axes_m = Vec3d::Zero();
};

struct MeshDetail {
  double ground_size_m = 20.0;      ///< sides of what is drawn of an infinite plane
  double ground_depth_m = 0.01;     ///< and its thickness
  std::size_t round_segments = 32;  ///< around a round shape, 4 or more
};

/// Calls visit(collider, mesh) in the order of forEachCollider.
void forEachColliderMesh(const Scene& scene, const MeshDetail& detail,
                         const std::function<void(const Collider&, const ColliderMesh&)>& visit);

}  // namespace ice_ice_baby
