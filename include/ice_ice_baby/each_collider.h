// Iterates over all colliders of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Calls visit(collider) in the order of forEachColliderList.
template <class Visit>
void forEachCollider(const Scene& scene, const Visit& visit) {
  forEachColliderList(scene, [&](const auto& list, const ColliderKind&) {
    for (const Collider& collider : list) visit(collider);
  });
}

}  // namespace ice_ice_baby
