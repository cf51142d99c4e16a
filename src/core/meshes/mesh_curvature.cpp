#include "meshes/mesh_curvature.h"

#include <algorithm>
#include <cmath>

#include "meshes/mesh_edges.h"
#include "meshes/triangle.h"

namespace ice_ice_baby {

namespace {

Triangle triangleOf(const TriangleMesh& mesh, Index k) {
  const auto& t = mesh.triangles[k];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// Angle by which the surface turns from one triangle to the next; above 0 where it is convex.
double angleBetween(const Triangle& a, const Triangle& b) {
  const Vec3d normal = a.normal().normalized(), other = b.normal().normalized();
  const double angle = std::acos(std::clamp(normal.dot(other), -1.0, 1.0));
  return (other - normal).dot(b.centre() - a.centre()) > 0 ? angle : -angle;
}

}  // namespace

std::vector<double> bendingOf(const TriangleMesh& mesh) {
  std::vector<double> bending(mesh.triangles.size(), 0.0);
  forEachEdge(edgeSidesOf(mesh), [&](const EdgeSide* first, const EdgeSide* last) {
    for (const EdgeSide* side = first; side + 1 < last; ++side) {
      const Index a = side[0].triangle, b = side[1].triangle;
      const Triangle one = triangleOf(mesh, a), two = triangleOf(mesh, b);
      const double angle = angleBetween(one, two);
      if (std::abs(angle) > kSharpEdge_deg * M_PI / 180) continue;
      const double turn = angle * (mesh.vertices[side->high] - mesh.vertices[side->low]).norm() / 2;
      bending[a] += turn / one.area();
      bending[b] += turn / two.area();
    }
  });
  return bending;
}

}  // namespace ice_ice_baby
