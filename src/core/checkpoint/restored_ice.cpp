// Checks and completes ice bodies and contacts read from a checkpoint, like restored_state.cpp. A
// body follows from the positions of its members, so a forged body is merely an unusual one.
#include <cmath>

#include "checkpoint/restored_state.h"
#include "ice/ice_bodies.h"
#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// Relative tolerance between a stored value and its recomputation.
constexpr double kRounding = 1e-6;

/// Largest multiplier of a contact; the shortest substep is 1e-7 s.
constexpr double kHardest_kg_m = 1e12;
constexpr double kShortest_s = 1e-8;

bool near(const Mat3<double>& a, const Mat3<double>& b) {
  return (a - b).norm() <= kRounding * b.norm();
}

bool isPlacement(const Placement& placement) {
  return placement.centre_m.cwiseAbs().maxCoeff() <= kMaxStoredCoordinate_m &&
         std::abs(placement.rotation.norm() - 1.0) <= kRounding &&
         near(placement.rotation_matrix, placement.rotation.toRotationMatrix());
}

}  // namespace

/// Mass and inertia of a body of ice.
template <class Real>
SolidMass IceBodies<Real>::massOfMembers(const IceBody& body) const {
  SolidMass mass;
  const auto count = static_cast<Index>(body.count());
  mass.mass_kg = particle_kg_ * double(count);
  mass.inertia = double(count) * ownInertia(count) * Mat3<double>::Identity();
  for (Index m = body.first; m < body.last; ++m) {
    const Vec3d& arm = offset_[m];
    mass.inertia +=
        particle_kg_ * (arm.squaredNorm() * Mat3<double>::Identity() - arm * arm.transpose());
  }
  return mass;
}

template <class Real>
void IceBodies<Real>::restoreBody(const IceBody& body, const Particles<Real>& particles) const {
  requireValid(belowOrNone(body.solid, solids_.size()), "body of an unknown solid");
  const bool placed = isPlacement(body.pose) && isPlacement(body.next) && isPlacement(body.hold) &&
                      isPlacement(body.grip);
  requireValid(placed, "ice body pose out of range");
  double radius_m = 0.0;
  for (Index m = body.first; m < body.last; ++m) {
    const Vec3d& arm = offset_[m];
    const Vec3d x = particles.position.at(place_[m]).template cast<double>();
    const double room_m = 0.1 * radius_m_ + 1e-5 * x.norm();
    requireValid(arm.norm() <= kMaxStoredCoordinate_m && (body.pose.at(arm) - x).norm() <= room_m &&
                     (body.next.at(arm) - x).norm() <= room_m && outward_[m].norm() <= 1.01,
                 "ice body far from its members");
    radius_m = std::max(radius_m, arm.norm());
  }
  const SolidMass mass = body.solid == kNone ? massOfMembers(body) : solids_[body.solid];
  const Mat3<double>& rotation_matrix = body.next.rotation_matrix;
  requireValid(
      std::abs(body.mass_kg - mass.mass_kg) <= kRounding * mass.mass_kg &&
          std::abs(body.mass_particles * particle_kg_ - mass.mass_kg) <= kRounding * mass.mass_kg &&
          std::abs(body.radius_m - radius_m) <= kRounding * radius_m_ &&
          near(body.inertia, mass.inertia) &&
          near(body.inertia * body.mobility, Mat3<double>::Identity()) &&
          near(body.mobility_now, rotation_matrix * body.mobility * rotation_matrix.transpose()),
      "ice body with an inertia that its members do not have");
  requireValid(body.fastest_m_s() <= kFastest_m_s && within(body.speed_m_s, 0, kFastest_m_s) &&
                   body.still_s >= 0.0 && within(body.grip_s, 0.0, 1.0),
               "ice body speed out of range");
}

template <class Real>
void IceBodies<Real>::restore(const Particles<Real>& particles, const Colliders<Real>& colliders) {
  const std::size_t members = place_.size();
  requireValid(
      distinct(place_, particles.size()) && offset_.size() == members && outward_.size() == members,
      "members that are not particles");
  body_of_.clear();
  for (const IceBody& body : bodies_) {
    const bool follows = body.first == body_of_.size() && body.first < body.surface_last &&
                         body.surface_last <= body.last && body.last <= members;
    requireValid(follows, "ice body without members");
    requireValid(belowOrNone(body.anchor, colliders.count()),
                 "ice body anchored to an unknown collider");
    requireValid(belowOrNone(body.island, bodies_.size()), "ice body in an unknown group");
    restoreBody(body, particles);
    requireValid(body.solid == kNone ||
                     bodyOfSolid(body.solid) == static_cast<Index>(&body - bodies_.data()),
                 "two bodies of one solid");
    body_of_.resize(body.last, static_cast<Index>(&body - bodies_.data()));
  }
  requireValid(body_of_.size() == members, "members of an unknown ice body");
  for (const Index member : renumbered_) {
    requireValid(belowOrNone(member, members), "unknown member number");
  }
  member_at_.assign(particles.size(), kNone);
  for (Index m = 0; m < members; ++m) member_at_[place_[m]] = m;
  makeChunks();
}

template <class Real>
void IceContacts<Real>::restore(const IceBodies<Real>& bodies) const {
  // Contacts may be those of the members before the latest change: followMembers renumbers them.
  const bool follows = generation_ + 1 == bodies.generation();
  const bool known = follows || generation_ == bodies.generation();
  requireValid(dt_s_ == 0.0 || within(dt_s_, kShortest_s, 1.0), "substep out of range");
  requireValid(known, "contact of removed ice bodies");
  const std::size_t members = follows ? bodies.renumbered().size() : bodies.members();
  const auto touches = [&](Index body, Index member) {
    return member < members && (follows || body == bodies.bodyOfMember(member));
  };
  for (const auto* contacts : {&walls_, &pairs_, &dormant_walls_, &dormant_pairs_}) {
    for (const Contact& contact : *contacts) {
      const bool alone = contact.b == kNone && contact.member_b == kNone;
      const bool other = alone || touches(contact.b, contact.member_b);
      requireValid(touches(contact.a, contact.member_a) && other, "contact of unknown ice bodies");
      requireValid(within(contact.normal_multiplier, 0.0, kHardest_kg_m) &&
                       contact.friction_multiplier.cwiseAbs().maxCoeff() <= kHardest_kg_m,
                   "contact force out of range");
    }
  }
  for (const Candidate& candidate : candidates_) {
    requireValid(candidate.a < members && candidate.b < members, "pair of unknown members");
  }
}

template void IceBodies<float>::restore(const Particles<float>&, const Colliders<float>&);
template void IceBodies<double>::restore(const Particles<double>&, const Colliders<double>&);
template void IceContacts<float>::restore(const IceBodies<float>&) const;
template void IceContacts<double>::restore(const IceBodies<double>&) const;

}  // namespace ice_ice_baby
