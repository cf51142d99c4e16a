// Parts of which the meshes of shapes are made.
#pragma once

#include "colliders/aligned_box.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Which sides of a box are drawn, and as seen from where.
struct BoxSides {
  bool from_inside = false;
  bool top = true;
};

/// Adds the sides of a box. @return its first vertex; vertex k of eight: bits for high x, y, z
Index addBox(ColliderMesh& mesh, const AlignedBox<double>& box, const BoxSides& sides);

/// Adds the twelve edges of a box whose first vertex is `first`.
void addBoxEdges(ColliderMesh& mesh, Index first);

/// Joins the tops of two boxes, one around the other, that lack theirs.
void addRing(ColliderMesh& mesh, Index inner, Index outer);

/// Adds a whole ellipsoid about the origin and notes its half axes.
/// @param segments around z
void addEllipsoid(ColliderMesh& mesh, const Vec3d& half_axes_m, std::size_t segments);

}  // namespace ice_ice_baby
