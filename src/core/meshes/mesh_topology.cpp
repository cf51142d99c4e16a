#include "meshes/mesh_topology.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ice_ice_baby {

MeshTopology topologyOf(const TriangleMesh& mesh) {
  struct Use {
    int forward = 0, backward = 0;
  };
  std::vector<std::array<Index, 3>> edges;  // lower vertex, higher vertex, whether it goes down
  edges.reserve(3 * mesh.triangles.size());
  MeshTopology topology;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k], to = t[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to ? 0u : 1u});
    }
    topology.volume_m3 +=
        mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size();) {
    Use use;
    const std::size_t first = k;
    for (; k < edges.size() && edges[k][0] == edges[first][0] && edges[k][1] == edges[first][1];
         ++k) {
      ++(edges[k][2] == 0 ? use.forward : use.backward);
    }
    if (use.forward == use.backward) continue;
    if (topology.closed()) {
      topology.first_fault_m =
          (mesh.vertices[edges[first][0]] + mesh.vertices[edges[first][1]]) / 2;
    }
    if (use.forward + use.backward == 1) {
      ++topology.open_edges;
    } else {
      ++topology.mixed_edges;
    }
  }
  return topology;
}

TriangleMesh welded(const TriangleMesh& mesh) {
  std::vector<Index> order(mesh.vertices.size()), number(mesh.vertices.size());
  for (Index k = 0; k < order.size(); ++k) order[k] = k;
  const auto less = [&](Index a, Index b) {
    const Vec3d &p = mesh.vertices[a], &q = mesh.vertices[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::stable_sort(order.begin(), order.end(), less);
  TriangleMesh result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || mesh.vertices[order[k]] != mesh.vertices[order[k - 1]]) {
      result.vertices.push_back(mesh.vertices[order[k]]);
    }
    number[order[k]] = static_cast<Index>(result.vertices.size() - 1);
  }
  for (const auto& t : mesh.triangles) {
    const std::array<Index, 3> corners{number[t[0]], number[t[1]], number[t[2]]};
    const Vec3d &a = result.vertices[corners[0]], &b = result.vertices[corners[1]],
                &c = result.vertices[corners[2]];
    const double longest2 =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    // Rounding gives a triangle without area a normal of any direction.
    if ((b - a).cross(c - a).norm() > 1e-12 * longest2) result.triangles.push_back(corners);
  }
  return result;
}

}  // namespace ice_ice_baby
