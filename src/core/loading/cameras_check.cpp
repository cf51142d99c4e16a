#include "loading/cameras_check.h"

#include <set>

#include "base/item_names.h"
#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

constexpr double kShortestLook_m = 1e-6;

}  // namespace

void requireCameras(const Scene& scene) {
  if (scene.cameras.size() > kMaxCameras) {
    throw InvalidInput("cameras has " + std::to_string(scene.cameras.size()) +
                       " entries; at most " + std::to_string(kMaxCameras) + " are allowed");
  }
  std::set<std::string> taken;
  forEachCollider(scene, [&](const Collider& collider) { taken.insert(collider.name); });
  for (const Solid& solid : scene.solids) taken.insert(solid.name);
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    const Camera& camera = scene.cameras[k];
    const std::string key = "cameras." + std::to_string(k);
    requireFrameName(key + ".name", camera.name);
    if (!taken.insert(camera.name).second) {
      throw InvalidInput(key + ".name = " + camera.name +
                         " is the name of another camera, of a collider or of a solid; choose "
                         "another");
    }
    requireFollowFrame(camera, "camera");
    if (!camera.follow_frame.empty()) continue;
    if ((camera.look_at_m - camera.position_m).norm() >= kShortestLook_m) continue;
    throw InvalidInput(key + ".look_at_m is the same as position_m; move one of them");
  }
}

}  // namespace ice_ice_baby
