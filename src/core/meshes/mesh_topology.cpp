#include "meshes/mesh_topology.h"

#include <algorithm>

#include "meshes/mesh_edges.h"

namespace ice_ice_baby {

MeshTopology topologyOf(const TriangleMesh& mesh) {
  MeshTopology topology;
  for (const auto& t : mesh.triangles) {
    topology.volume_m3 +=
        mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  }
  forEachEdge(edgeSidesOf(mesh), [&](const EdgeSide* first, const EdgeSide* last) {
    const auto backward = std::count_if(first, last, [](const EdgeSide& s) { return s.backward; });
    if (2 * backward == last - first) return;
    if (topology.closed()) {
      topology.first_fault_m = (mesh.vertices[first->low] + mesh.vertices[first->high]) / 2;
    }
    ++(last - first == 1 ? topology.open_edges : topology.mixed_edges);
  });
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
