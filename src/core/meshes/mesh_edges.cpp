#include "meshes/mesh_edges.h"

#include <algorithm>
#include <tuple>

namespace ice_ice_baby {

std::vector<EdgeSide> edgeSidesOf(const TriangleMesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (Index k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    for (std::size_t c = 0; c < 3; ++c) {
      const Index from = t[c], to = t[(c + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), k, to < from});
    }
  }
  const auto place = [](const EdgeSide& side) {
    return std::tie(side.low, side.high, side.triangle, side.backward);
  };
  std::sort(sides.begin(), sides.end(),
            [&](const EdgeSide& a, const EdgeSide& b) { return place(a) < place(b); });
  return sides;
}

}  // namespace ice_ice_baby
