// Every collider of a scene, whatever its shape.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Calls visit(collider) for containers, then planes, then spheres.
template <class Visit>
void forEachCollider(const Scene& scene, const Visit& visit) {
  for (const Collider& collider : scene.containers) visit(collider);
  for (const Collider& collider : scene.planes) visit(collider);
  for (const Collider& collider : scene.spheres) visit(collider);
}

}  // namespace ice_ice_baby
