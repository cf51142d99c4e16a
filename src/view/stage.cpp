#include "stage.h"

#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

namespace {

/// The outline of what has an end. @param plates whether grounds count
Eigen::AlignedBox3f boundsOfColliders(const Scene& scene, bool plates) {
  Eigen::AlignedBox3f bounds;
  forEachColliderMesh(scene, {}, [&](const Collider& c, const ColliderMesh& mesh) {
    if (mesh.infinite || (mesh.look == Look::kGround && !plates)) return;
    const Pose<float> pose = c.pose().cast<float>();
    const auto extend = [&](Index k) {
      bounds.extend(pose.toWorld(mesh.vertices[k].cast<float>()));
    };
    for (const auto& [a, b] : mesh.edges) extend(a), extend(b);
    if (!mesh.edges.empty()) return;
    for (Index k = 0; k < mesh.vertices.size(); ++k) extend(k);
  });
  return bounds;
}

}  // namespace

Eigen::AlignedBox3f boundsOf(const Scene& scene) {
  Eigen::AlignedBox3f bounds = boundsOfColliders(scene, false);
  for (const Block& block : scene.blocks) {
    bounds.extend(block.min_m.cast<float>()).extend(block.max_m.cast<float>());
  }
  for (const Solid& solid : scene.solids) bounds.extend(solid.position_m.cast<float>());
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector3f::Zero()).extend(Eigen::Vector3f::Ones());
  return bounds;
}

Eigen::AlignedBox3f stageOf(const Scene& scene) {
  bool glass = false;
  forEachColliderMesh(scene, {}, [&](const Collider&, const ColliderMesh& mesh) {
    glass = glass || mesh.look == Look::kGlass;
  });
  return glass ? boundsOfColliders(scene, true) : boundsOf(scene);
}

}  // namespace ice_ice_baby
