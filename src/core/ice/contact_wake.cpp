// Wakes the ice bodies that something else touches.
#include <utility>

#include "ice/ice_contacts.h"

namespace ice_ice_baby {

template <class Real>
void IceContacts<Real>::wakeByColliders(IceBodies<Real>& bodies) {
  for (std::size_t k = 0; k < faces_.count(); ++k) {
    if (!faces_.moves(k)) continue;
    for (Index b = 0; b < bodies.count(); ++b) {
      const IceBody& body = bodies.body(b);
      const double reach = body.radius_m + margin_m_;
      if (!body.asleep || !faces_.near(k, body.pose.centre_m, body.pose.centre_m, reach)) continue;
      bodies.wakeInFlight(b);
    }
  }
}

/// Runs before contacts are found, because a body that wakes needs its contacts with all others,
/// including sleeping ones.
template <class Real>
void IceContacts<Real>::wakeByBodies(IceBodies<Real>& bodies) {
  const double reach = contact_m_ + margin_m_;
  for (const Candidate& candidate : candidates_) {
    Index sleeper = bodies.bodyOfMember(candidate.a), other = bodies.bodyOfMember(candidate.b);
    if (bodies.body(sleeper).asleep == bodies.body(other).asleep) continue;
    if (!bodies.body(sleeper).asleep) std::swap(sleeper, other);
    // Uses the speed before this substep, as a body at rest starts each substep falling slightly.
    if (bodies.body(other).speed_m_s <= bodies.sleepSpeed_m_s()) continue;
    const Vec3d apart =
        bodies.body(bodies.bodyOfMember(candidate.a)).next.at(bodies.offset(candidate.a)) -
        bodies.body(bodies.bodyOfMember(candidate.b)).next.at(bodies.offset(candidate.b));
    if (apart.squaredNorm() < reach * reach) bodies.wakeInFlight(sleeper);
  }
}

template class IceContacts<float>;
template class IceContacts<double>;

}  // namespace ice_ice_baby
