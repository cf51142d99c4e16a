#include "ice_ice_baby/mesh_warnings.h"

#include "ice_ice_baby/errors.h"
#include "meshes/mesh_topology.h"

namespace ice_ice_baby {

namespace {

std::string pointText(const Vec3d& point) {
  return "[" + numberText(point.x()) + ", " + numberText(point.y()) + ", " + numberText(point.z()) +
         "]";
}

std::string warningOf(const MeshTopology& topology) {
  if (topology.open_edges > 0) {
    return " is open: " + std::to_string(topology.open_edges) +
           " edges have a triangle on one side only, the first near " +
           pointText(topology.first_fault_m) +
           " m; it counts as thin walls that hold water on both sides";
  }
  return " is no closed surface: triangles meet with opposite sides or more than two at an edge, "
         "first near " +
         pointText(topology.first_fault_m) +
         " m; it counts as thin walls that hold water on both sides";
}

}  // namespace

std::vector<std::string> meshWarnings(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Mesh& mesh : scene.meshes) {
    if (!mesh.triangles) continue;
    const MeshTopology topology = topologyOf(*mesh.triangles);
    if (!topology.closed()) warnings.push_back("mesh " + mesh.name + warningOf(topology));
  }
  return warnings;
}

}  // namespace ice_ice_baby
