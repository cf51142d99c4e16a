// Whether triangles enclose a solid.
#pragma once

#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

struct MeshTopology {
  std::size_t open_edges = 0;  ///< edges of a single triangle
  std::size_t mixed_edges =
      0;  ///< edges of more than two triangles, or of two that face each other
  Vec3d first_fault_m = Vec3d::Zero();  ///< middle of the first of these edges
  double volume_m3 = 0.0;               ///< enclosed; below 0 if the triangles face inwards

  /// Whether the triangles enclose a solid, all facing the same way.
  bool closed() const { return open_edges == 0 && mixed_edges == 0; }
};

MeshTopology topologyOf(const TriangleMesh& mesh);

/// The mesh with vertices at the same place joined, and without triangles that have no area.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace ice_ice_baby
