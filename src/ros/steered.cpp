#include "steered.h"

#include "ice_ice_baby/each_collider.h"

namespace ice_ice_baby {

namespace {

constexpr const char* kNouns[] = {"collider", "source", "heat region",
                                  "solid"};  // of each SteeredKind

}  // namespace

std::string Steered::words() const {
  return std::string(kNouns[static_cast<std::size_t>(kind)]) + " " + name;
}

std::vector<Steered> everySteered(const Scene& scene) {
  std::vector<Steered> all;
  const auto add = [&](SteeredKind kind, const auto& part) {
    all.push_back({kind, part.name, part.follow_frame, part.pose()});
  };
  forEachCollider(scene, [&](const Collider& one) { add(SteeredKind::kCollider, one); });
  for (const Source& one : scene.sources) add(SteeredKind::kSource, one);
  for (const HeatRegionParams& one : scene.heat_regions) add(SteeredKind::kHeatRegion, one);
  return all;
}

Posed poseNow(const Simulation& simulation, const Steered& what) {
  if (what.kind == SteeredKind::kSource) return simulation.sourcePose(what.name);
  if (what.kind == SteeredKind::kHeatRegion) return simulation.heatRegionPose(what.name);
  if (what.kind == SteeredKind::kSolid) return simulation.solidPose(what.name);
  return simulation.colliderPose(what.name);
}

void moveSteered(Simulation& simulation, const Steered& what, const Posed& pose) {
  if (what.kind == SteeredKind::kSource) return simulation.moveSource(what.name, pose);
  if (what.kind == SteeredKind::kHeatRegion) return simulation.moveHeatRegion(what.name, pose);
  if (what.kind == SteeredKind::kSolid) return simulation.holdSolid(what.name, pose);
  simulation.moveCollider(what.name, pose);
}

void placeSteered(Simulation& simulation, const std::vector<SteeredPlacement>& placements) {
  std::vector<ColliderPlacement> colliders;
  for (const auto& [what, pose] : placements) {
    if (what.kind == SteeredKind::kCollider) colliders.push_back({what.name, pose});
    if (what.kind == SteeredKind::kSource) simulation.placeSource(what.name, pose);
    if (what.kind == SteeredKind::kHeatRegion) simulation.moveHeatRegion(what.name, pose);
  }
  simulation.placeColliders(colliders);
}

}  // namespace ice_ice_baby
