// What a robot can move: colliders, sources and heat regions, and solids that it holds.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

enum class SteeredKind { kCollider, kSource, kHeatRegion, kSolid };

/// A part of the scene that can be moved.
struct Steered {
  SteeredKind kind;
  std::string name;
  std::string follow_frame;  ///< "": none
  Posed pose;                ///< in the scene file

  /// "collider cup"
  std::string words() const;
};

/// All of a scene but its solids, which move by themselves; each kind in the order of the scene.
std::vector<Steered> everySteered(const Scene& scene);

/// Pose now. @throws InvalidInput as Simulation, like the next two
Posed poseNow(const Simulation& simulation, const Steered& what);
/// Moves it to a pose over the next frame; a solid is held at the pose.
void moveSteered(Simulation& simulation, const Steered& what, const Posed& pose);
struct SteeredPlacement {
  Steered what;
  Posed pose;
};
/// Places all at once, without motion: colliders together, as they may change places.
void placeSteered(Simulation& simulation, const std::vector<SteeredPlacement>& placements);

}  // namespace ice_ice_baby
