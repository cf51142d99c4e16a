// Force and torque on a collider.
#pragma once

#include <string>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// What water and ice do to a collider, in its own frame and about the origin of that frame.
struct ColliderWrench {
  std::string name;                  ///< of the collider in the scene
  Vec3d force_n = Vec3d::Zero();     ///< N
  Vec3d torque_n_m = Vec3d::Zero();  ///< N m
};

}  // namespace ice_ice_baby
