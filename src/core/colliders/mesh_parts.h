// Building blocks for meshes of shapes.
#pragma once

#include "colliders/aligned_box.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

/// Selects the sides of a box to draw and their orientation.
struct BoxSides {
  bool from_inside = false;
  bool top = true;
};

/// Adds the sides of a box. @return its first vertex; vertex k of eight: bits for high x, y, z
Index addBox(ColliderMesh& mesh, const AlignedBox<double>& box, const BoxSides& sides);

/// Adds the twelve edges of a box whose first vertex is `first`.
void addBoxEdges(ColliderMesh& mesh, Index first);

/// Connects the open tops of two nested boxes.
void addRing(ColliderMesh& mesh, Index inner, Index outer);

/// Adds an ellipsoid about the origin and stores its semi-axes.
/// @param segments around z
void addEllipsoid(ColliderMesh& mesh, const Vec3d& half_axes_m, std::size_t segments);

}  // namespace ice_ice_baby
