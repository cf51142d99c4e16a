// Colliders that jump to another pose: their contents move along, particles that they land on are
// moved out of them, and none of this counts as velocity.
#pragma once

#include <vector>

#include "colliders/colliders.h"
#include "ice/ice_bodies.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Makes colliders jump that would move farther than `max_m` in a frame: beyond the speed limit no
/// particle could follow them or move out of their way.
/// @return the colliders that jumped
template <class Real>
std::vector<Jump<Real>> jumpFastColliders(Colliders<Real>& colliders,
                                          const Particles<Real>& particles, double max_m);

/// Moves the contents of containers that jumped along with them and rotates their velocities.
/// @param bodies ice bodies, whose members are skipped; or null
/// @return number of particles moved
template <class Real>
std::size_t carry(const std::vector<Jump<Real>>& jumps, const Colliders<Real>& colliders,
                  const IceBodies<Real>* bodies, Particles<Real>& particles);

/// Moves water out of colliders that it overlaps.
/// @param bodies ice bodies, whose members are skipped; or null
/// @return the largest displacement, m
template <class Real>
double expel(const Colliders<Real>& colliders, const IceBodies<Real>* bodies,
             Particles<Real>& particles);

}  // namespace ice_ice_baby
