// Colliders that are somewhere else at once: what they hold comes along, what they land on is put
// beside them, and nothing of it counts as speed.
#pragma once

#include <vector>

#include "colliders/colliders.h"
#include "ice/ice_bodies.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Lets colliders jump that are about to go further in a frame than `most_m`: faster than the speed
/// limit nothing could follow them or get out of their way.
/// @return those that jumped
template <class Real>
std::vector<Jump<Real>> jumpFastColliders(Colliders<Real>& colliders,
                                          const Particles<Real>& particles, double most_m);

/// Takes along what lies in containers that jumped, its velocity turned with them.
/// @param bodies whose members stay where they are, or null
/// @return particles that were taken along
template <class Real>
std::size_t carry(const std::vector<Jump<Real>>& jumps, const Colliders<Real>& colliders,
                  const IceBodies<Real>* bodies, Particles<Real>& particles);

/// Puts water that lies in a collider beside it.
/// @param bodies whose members stay where they are, or null
/// @return the longest way that a particle was put aside, m
template <class Real>
double expel(const Colliders<Real>& colliders, const IceBodies<Real>* bodies,
             Particles<Real>& particles);

}  // namespace ice_ice_baby
