// Surfaces for the tests of meshes.
#pragma once

#include "fixtures.h"
#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby::test {

/// A box from `low` to `high`, every side divided into 2 n^2 triangles.
inline TriangleMesh boxMesh(const Vec3d& low, const Vec3d& high, int n = 1) {
  TriangleMesh mesh;
  const Vec3d size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int side : {0, 1}) {
      const auto first = static_cast<Index>(mesh.vertices.size());
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          Vec3d vertex = low;
          vertex[axis] += side * size[axis];
          vertex[u] = i == n ? high[u] : low[u] + size[u] * i / n;
          vertex[v] = j == n ? high[v] : low[v] + size[v] * j / n;
          if (side == 1) vertex[axis] = high[axis];
          mesh.vertices.push_back(vertex);
        }
      }
      const auto at = [&](int i, int j) { return first + Index(i * (n + 1) + j); };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          mesh.triangles.push_back(side == 1 ? std::array<Index, 3>{a, b, c}
                                             : std::array<Index, 3>{a, c, b});
          mesh.triangles.push_back(side == 1 ? std::array<Index, 3>{a, c, d}
                                             : std::array<Index, 3>{a, d, c});
        }
      }
    }
  }
  return mesh;
}

/// Any triangles within a box.
inline TriangleMesh anyTriangles(Random& random, int count, double size_m) {
  TriangleMesh mesh;
  for (int k = 0; k < count; ++k) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(random.inBox(Vec3d::Constant(-size_m), Vec3d::Constant(size_m)));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace ice_ice_baby::test
