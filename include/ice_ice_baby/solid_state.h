// Where a floating solid is and how it moves.
#pragma once

#include <string>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

struct SolidState {
  std::string name;
  Posed pose;                                    ///< of its frame, in the scene
  Vec3d velocity_m_s = Vec3d::Zero();            ///< of the origin of that frame
  Vec3d angular_velocity_rad_s = Vec3d::Zero();  ///< about the axes of the scene
  bool asleep = false;
  bool held = false;  ///< whether it is moved by holdSolid
};

}  // namespace ice_ice_baby
