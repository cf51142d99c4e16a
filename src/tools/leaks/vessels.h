// Vessels of about 0.1 m for trials of leaks.
#pragma once

#include <optional>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby::leaks {

/// The frame of a vessel has its origin in the middle of the inner floor and z towards the rim.
struct Vessel {
  Scene scene;         ///< colliders at the origin of the frame of the vessel, and the water
  TriangleMesh walls;  ///< all triangles of the colliders, in the frame of the vessel
  TriangleMesh room;   ///< closed surface around the inside, up to the rim
  std::optional<double> rim_m;     ///< height of the rim; none: the vessel is closed
  Vec3d centre_m = Vec3d::Zero();  ///< of its rotations
};

std::vector<std::string> vesselNames();

/// @param in_box whether an open vessel stands in a closed box that moves along, so that its water
/// stays near and meets the walls from both sides
/// @throws InvalidInput for an unknown name
Vessel makeVessel(const std::string& name, double spacing_m, bool in_box);

}  // namespace ice_ice_baby::leaks
