#include "ice_ice_baby/collider_mesh.h"

#include "colliders/shape.h"

namespace ice_ice_baby {

void forEachColliderMesh(const Scene& scene, const MeshDetail& detail,
                         const std::function<void(const Collider&, const ColliderMesh&)>& visit) {
  forEachColliderList(scene, [&](const auto& list, const ColliderKind&) {
    for (const auto& item : list) visit(item, makeShape<double>(item, 0.0).mesh(detail));
  });
}

}  // namespace ice_ice_baby
