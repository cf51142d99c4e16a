// Density of colliders at a point.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Density of colliders at a particle centre, relative to rest density, and its gradient.
template <class Real>
struct WallSample {
  Real value = 0;                            ///< dimensionless
  Vec3<Real> gradient = Vec3<Real>::Zero();  ///< 1/m
};

}  // namespace ice_ice_baby
