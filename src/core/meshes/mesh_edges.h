// The edges of a mesh with the triangles beside them.
#pragma once

#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

/// One triangle at an edge.
struct EdgeSide {
  Index low, high;  ///< vertices of the edge
  Index triangle;
  bool backward;  ///< whether the triangle passes it from high to low
};

/// All sides of all triangles; those of one edge stand together, in the order of the triangles.
std::vector<EdgeSide> edgeSidesOf(const TriangleMesh& mesh);

/// Calls visit(first, last) for the sides of every edge, in the order of its vertices.
template <class Visit>
void forEachEdge(const std::vector<EdgeSide>& sides, const Visit& visit) {
  const EdgeSide* const end = sides.data() + sides.size();
  for (const EdgeSide* first = sides.data(); first != end;) {
    const EdgeSide* last = first;
    while (last != end && last->low == first->low && last->high == first->high) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace ice_ice_baby
