#include "loading/gauges_check.h"

#include <algorithm>
#include <set>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

void requireFrame(const Gauge& gauge, const std::string& key,
                  const std::vector<std::string>& colliders) {
  if (gauge.frame.empty()) return;
  if (std::find(colliders.begin(), colliders.end(), gauge.frame) != colliders.end()) return;
  throw InvalidInput(key + ".frame = " + shortened(gauge.frame) + " is no collider of the scene" +
                     (colliders.empty() ? ", which has none" : suggestion(gauge.frame, colliders)));
}

}  // namespace

void requireGauges(const Scene& scene) {
  if (scene.gauges.size() > kMaxGauges) {
    throw InvalidInput("gauges has " + std::to_string(scene.gauges.size()) + " entries; at most " +
                       std::to_string(kMaxGauges) + " are allowed");
  }
  std::vector<std::string> colliders;
  forEachCollider(scene, [&](const Collider& collider) { colliders.push_back(collider.name); });
  std::set<std::string> taken(colliders.begin(), colliders.end());
  for (std::size_t k = 0; k < scene.gauges.size(); ++k) {
    const Gauge& gauge = scene.gauges[k];
    const std::string key = "gauges." + std::to_string(k);
    requireFrameName(key + ".name", gauge.name);
    if (!taken.insert(gauge.name).second) {
      throw InvalidInput(key + ".name = " + gauge.name +
                         " is the name of another gauge or of a collider; choose another");
    }
    requireFrame(gauge, key, colliders);
  }
}

}  // namespace ice_ice_baby
