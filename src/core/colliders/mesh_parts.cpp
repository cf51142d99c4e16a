#include "colliders/mesh_parts.h"

#include <cmath>

namespace ice_ice_baby {

namespace {

/// Four corners, counterclockwise from outside.
void addQuad(ColliderMesh& mesh, Index a, Index b, Index c, Index d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

}  // namespace

Index addBox(ColliderMesh& mesh, const AlignedBox<double>& box, const BoxSides& sides) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.emplace_back(k & 1 ? box.high.x() : box.low.x(),
                               k & 2 ? box.high.y() : box.low.y(),
                               k & 4 ? box.high.z() : box.low.z());
  }
  for (Index axis = 0; axis < 3; ++axis) {
    const Index u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
    for (const Index high : {0u, 1u}) {
      if (axis == 2 && high == 1 && !sides.top) continue;
      const Index corner = first + (high << axis);
      const bool ahead = (high == 1) != sides.from_inside;
      addQuad(mesh, corner, corner + (ahead ? u : v), corner + u + v, corner + (ahead ? v : u));
    }
  }
  return first;
}

void addBoxEdges(ColliderMesh& mesh, Index first) {
  for (Index corner = 0; corner < 8; ++corner) {
    for (const Index axis : {1u, 2u, 4u}) {
      if (!(corner & axis)) mesh.edges.push_back({first + corner, first + (corner | axis)});
    }
  }
}

void addRing(ColliderMesh& mesh, Index inner, Index outer) {
  constexpr std::array<Index, 5> kTop{4, 5, 7, 6, 4};  // counterclockwise seen from above
  for (std::size_t k = 0; k < 4; ++k) {
    addQuad(mesh, outer + kTop[k], outer + kTop[k + 1], inner + kTop[k + 1], inner + kTop[k]);
  }
}

void addEllipsoid(ColliderMesh& mesh, const Vec3d& half_axes_m, std::size_t segments) {
  mesh.half_axes_m = half_axes_m;
  const auto around = static_cast<Index>(segments);
  const Index rings = around / 2;
  const auto first = static_cast<Index>(mesh.vertices.size());
  const auto add = [&](const Vec3d& direction) {
    mesh.vertices.push_back(direction.cwiseProduct(half_axes_m));
  };
  add(Vec3d::UnitZ());
  for (Index ring = 1; ring < rings; ++ring) {
    const double down = M_PI * ring / rings;
    for (Index k = 0; k < around; ++k) {
      const double turn = 2 * M_PI * k / around;
      add({std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down)});
    }
  }
  add(-Vec3d::UnitZ());
  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  const auto at = [&](Index ring, Index k) { return first + 1 + (ring - 1) * around + k % around; };
  for (Index k = 0; k < around; ++k) {
    mesh.triangles.push_back({first, at(1, k), at(1, k + 1)});
    for (Index ring = 1; ring + 1 < rings; ++ring) {
      addQuad(mesh, at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
    mesh.triangles.push_back({last, at(rings - 1, k + 1), at(rings - 1, k)});
  }
}

}  // namespace ice_ice_baby
