#include "meshes/mesh_curvature.h"

#include <algorithm>
#include <cmath>

#include "meshes/triangle.h"

namespace ice_ice_baby {

namespace {

struct Side {
  Index low, high, triangle;

  bool operator<(const Side& other) const {
    return low != other.low     ? low < other.low
           : high != other.high ? high < other.high
                                : triangle < other.triangle;
  }
};

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
  std::vector<Side> sides;
  for (Index k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    for (std::size_t c = 0; c < 3; ++c) {
      const Index from = t[c], to = t[(c + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), k});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<double> bending(mesh.triangles.size(), 0.0);
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Side &a = sides[k], &b = sides[k + 1];
    if (a.low != b.low || a.high != b.high) continue;
    const Triangle one = triangleOf(mesh, a.triangle), two = triangleOf(mesh, b.triangle);
    const double angle = angleBetween(one, two);
    if (std::abs(angle) > kSharpEdge_deg * M_PI / 180) continue;
    const double turn = angle * (mesh.vertices[a.high] - mesh.vertices[a.low]).norm() / 2;
    bending[a.triangle] += turn / one.area();
    bending[b.triangle] += turn / two.area();
  }
  return bending;
}

}  // namespace ice_ice_baby
