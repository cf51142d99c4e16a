// Surfaces of colliders as triangles, for drawing.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

enum class Look { kGlass, kGround, kObject };

/// Closed surface of a solid in the frame of its collider.
struct ColliderMesh {
  std::vector<Vec3d> vertices;                  ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise from outside
  std::vector<std::array<Index, 2>> edges;      ///< lines to draw if the surface is transparent
  Look look = Look::kObject;
  bool infinite = false;  ///< the solid extends beyond the mesh
  std::string resource;   ///< address of the file that holds it, for viewers that read files
  Vec3d resource_scale = Vec3d::Ones();  ///< metres per unit of that file, along each axis
  /// Semi-axes, m, of a sphere or ellipsoid about the origin, for viewers with a primitive for it;
  /// 0 for any other shape.
  Vec3d half_axes_m = Vec3d::Zero();
};

struct MeshDetail {
  double ground_size_m = 20.0;      ///< side of the drawn part of an infinite plane
  double ground_depth_m = 0.01;     ///< thickness of that part
  std::size_t round_segments = 32;  ///< segments around a round shape, at least 4
};

/// Calls visit(collider, mesh) in the order of forEachCollider.
void forEachColliderMesh(const Scene& scene, const MeshDetail& detail,
                         const std::function<void(const Collider&, const ColliderMesh&)>& visit);

/// Calls visit(solid, mesh) for the true shape of every floating solid, in the frame of the solid.
void forEachSolidMesh(const Scene& scene, const MeshDetail& detail,
                      const std::function<void(const Solid&, const ColliderMesh&)>& visit);

}  // namespace ice_ice_baby
