// Validates the cameras of a scene.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Refuses more than kMaxCameras cameras, names that are taken or unfit, and cameras that look at
/// the place where they stand.
/// @throws InvalidInput that names the camera, the value and the cure
void requireCameras(const Scene& scene);

}  // namespace ice_ice_baby
