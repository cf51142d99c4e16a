// What water does to a collider at one point.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// What a stage of a substep does to one collider at one point.
template <class Real>
struct WallLoad {
  Index collider;
  Vec3<Real> point;  ///< m
  Vec3<Real> push;   ///< displacement of a particle that the same impulse causes, m
};

}  // namespace ice_ice_baby
