// Blocks that are given in the frame of a collider.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Puts every block with a `frame` where that collider begins, in the coordinates of the scene: its
/// box, its rotation and its velocities. No block has a frame afterwards.
/// @throws InvalidInput for a frame that is no collider of the scene, and for a block that lies
///   outside the range of coordinates then
void placeInFrames(Scene& scene);

}  // namespace ice_ice_baby
