#include "sequences/collider_file.h"

#include <algorithm>
#include <cstdio>

#include "base/written_file.h"
#include "ice_ice_baby/collider_mesh.h"
#include "stage.h"

namespace ice_ice_baby {

namespace {

/// Round shapes as round as a picture of a thousand pixels shows.
constexpr std::size_t kRoundSegments = 96;

/// Text of an OBJ file, whose vertices are counted through all objects.
class ObjText {
 public:
  void add(const std::string& name, const char* material, const ColliderMesh& mesh,
           const Posed& pose) {
    text_ += "o " + name + "\nusemtl " + material + "\n";
    char line[128];
    for (const Vec3d& vertex : mesh.vertices) {
      const Vec3d at = pose.toWorld(vertex);
      std::snprintf(line, sizeof line, "v %.7g %.7g %.7g\n", at.x(), at.y(), at.z());
      text_ += line;
    }
    for (const auto& corners : mesh.triangles) {
      std::snprintf(line, sizeof line, "f %zu %zu %zu\n", first_ + corners[0], first_ + corners[1],
                    first_ + corners[2]);
      text_ += line;
    }
    first_ += mesh.vertices.size();
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_ = "# metres\n";
  std::size_t first_ = 1;
};

const char* materialOf(const Collider& collider, Look look) {
  if (collider.opacity == 0.0) return "hidden";
  return look == Look::kGlass ? "glass" : look == Look::kGround ? "ground" : "object";
}

/// A ground without end is drawn a few times as wide as the scene.
MeshDetail detailFor(const Scene& scene) {
  MeshDetail detail;
  const Eigen::Vector3f sizes = boundsOf(scene).sizes();
  detail.ground_size_m = 6.0 * double(std::max(sizes.x(), sizes.y()));
  detail.round_segments = kRoundSegments;
  return detail;
}

}  // namespace

void writeColliders(const std::string& path, const Simulation& simulation) {
  ObjText objects;
  const Scene& scene = simulation.scene();
  forEachColliderMesh(scene, detailFor(scene),
                      [&](const Collider& collider, const ColliderMesh& mesh) {
                        objects.add(collider.name, materialOf(collider, mesh.look), mesh,
                                    simulation.colliderPose(collider.name));
                      });
  writeFile(path, objects.text());
}

void writeSolids(const std::string& path, const Simulation& simulation) {
  ObjText objects;
  const std::vector<SolidState> states = simulation.solids();
  forEachSolidMesh(simulation.scene(), detailFor(simulation.scene()),
                   [&](const Solid& solid, const ColliderMesh& mesh) {
                     const auto state =
                         std::find_if(states.begin(), states.end(),
                                      [&](const SolidState& s) { return s.name == solid.name; });
                     if (state != states.end()) objects.add(solid.name, "solid", mesh, state->pose);
                   });
  writeFile(path, objects.text());
}

}  // namespace ice_ice_baby
