#include "ice_ice_baby/collider_mesh.h"

#include "colliders/shape.h"

namespace ice_ice_baby {

namespace {

void addResource(const Collider&, ColliderMesh&) {}

void addResource(const Mesh& item, ColliderMesh& mesh) {
  if (item.file.empty()) return;
  const bool path = item.file.front() == '/';
  mesh.resource = path ? "file://" + item.file : item.file;
  mesh.resource_scale = item.scale * item.stretch;
}

}  // namespace

void forEachColliderMesh(const Scene& scene, const MeshDetail& detail,
                         const std::function<void(const Collider&, const ColliderMesh&)>& visit) {
  forEachColliderList(scene, [&](const auto& list, const ColliderKind&) {
    for (const auto& item : list) {
      ColliderMesh mesh = makeShape<double>(item, 0.0).mesh(detail);
      addResource(item, mesh);
      visit(item, mesh);
    }
  });
}

void forEachSolidMesh(const Scene& scene, const MeshDetail& detail,
                      const std::function<void(const Solid&, const ColliderMesh&)>& visit) {
  for (const Solid& solid : scene.solids) {
    visitShape(solid, [&](const auto& shape) {
      visit(solid, makeShape<double>(shape, 0.0).mesh(detail));
    });
  }
}

}  // namespace ice_ice_baby
