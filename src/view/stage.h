// What of a scene should be in view.
#pragma once

#include <Eigen/Geometry>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Box that holds everything in the scene that has an end.
Eigen::AlignedBox3f boundsOf(const Scene& scene);

/// Box that holds its colliders but grounds without end; without a container what boundsOf has.
Eigen::AlignedBox3f stageOf(const Scene& scene);

}  // namespace ice_ice_baby
