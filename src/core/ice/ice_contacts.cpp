// Finds the contacts of the members of ice bodies.
#include "ice/ice_contacts.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

/// Faces closer than this to a member, in spacings, count as contacts before they touch, so that a
/// rotation within the substep is caught.
constexpr double kMargin_d = 0.1;

/// Relative motion, in spacings, before the neighbour lists are rebuilt: their skin.
constexpr double kApproach_d = 0.3;

/// A member that is less exposed than the other by this much has the flatter surroundings.
constexpr double kFlatter = 0.8;

/// How far a member's face extends beside it, in contact distances: more than half the diagonal of
/// a square of four members, so that faces have no holes.
constexpr double kBeside = 0.75;

/// Members closer than this, in spacings, count as coincident.
constexpr double kCoincident_d = 1e-6;

}  // namespace

template <class Real>
IceContacts<Real>::IceContacts(const Scene& scene)
    : spacing_m_(scene.fluid.spacing_m),
      contact_m_(scene.thermal.enabled || scene.solids.empty()
                     ? scene.fluid.spacing_m / std::cbrt(scene.ice.density_ratio)
                     : scene.fluid.spacing_m),
      friction_(scene.ice.friction),
      margin_m_(kMargin_d * spacing_m_) {
  for (const Solid& solid : scene.solids) solid_friction_.push_back(solid.friction);
}

/// Of two solids the mean counts, of a solid and ice that of the solid.
template <class Real>
double IceContacts<Real>::frictionBetween(const IceBody& a, const IceBody& b) const {
  if (a.solid == kNone && b.solid == kNone) return friction_;
  if (a.solid == kNone) return solid_friction_[b.solid];
  if (b.solid == kNone) return solid_friction_[a.solid];
  return (solid_friction_[a.solid] + solid_friction_[b.solid]) / 2;
}

template <class Real>
void IceContacts<Real>::find(IceBodies<Real>& bodies, const VectorField<Real>& predicted,
                             const Neighbours<Real>& neighbours, const Colliders<Real>& colliders) {
  followMembers(bodies);
  old_walls_.swap(walls_);
  old_pairs_.swap(pairs_);
  walls_.clear();
  pairs_.clear();
  faces_.take(colliders);
  if (builds_ != neighbours.builds()) findCandidates(bodies, predicted, neighbours);
  builds_ = neighbours.builds();
  wakeByColliders(bodies);
  wakeByBodies(bodies);
  findSwept(bodies);
  findWalls(bodies);
  for (const Candidate& candidate : candidates_) addPair(bodies, candidate);
  found_.resize(bodies.count());
  for (Index b = 0; b < bodies.count(); ++b) found_[b] = bodies.body(b).next;
  const double ratio = dt_s_ > 0 ? bodies.dt_s() / dt_s_ : 1.0;
  startWarm(walls_, old_walls_, ratio * ratio);
  startWarm(pairs_, old_pairs_, ratio * ratio);
  startWarm(walls_, dormant_walls_, 1.0);
  startWarm(pairs_, dormant_pairs_, 1.0);
  layDown(bodies, old_walls_, dormant_walls_);
  layDown(bodies, old_pairs_, dormant_pairs_);
  keepSupports(bodies, walls_);
  keepSupports(bodies, pairs_);
  addSwept();
  dt_s_ = bodies.dt_s();
  warm_ = true;
}

/// Renumbers the contacts of the latest substep after members were renumbered.
template <class Real>
void IceContacts<Real>::followMembers(const IceBodies<Real>& bodies) {
  if (generation_ == bodies.generation()) return;
  const bool known = generation_ + 1 == bodies.generation();
  generation_ = bodies.generation();
  builds_ = 0;
  candidates_.clear();
  if (!known) {
    for (auto* contacts : {&walls_, &pairs_, &dormant_walls_, &dormant_pairs_}) contacts->clear();
    return;
  }
  const auto follow = [&](Index member) {
    return member == kNone ? kNone : bodies.renumbered()[member];
  };
  const auto update = [&](std::vector<Contact>& contacts) {
    std::size_t kept = 0;
    for (const Contact& contact : contacts) {
      const Index a = follow(contact.member_a), b = follow(contact.member_b);
      if (a == kNone || (contact.member_b != kNone && b == kNone)) continue;
      Contact& moved = contacts[kept++] = contact;
      moved.member_a = a;
      moved.member_b = b;
      const std::uint64_t low = contact.key & 0xffffffffu;
      moved.key = (std::uint64_t(a) << 32) | (b == kNone ? low : b);
      moved.a = bodies.bodyOfMember(a);
      if (b != kNone) moved.b = bodies.bodyOfMember(b);
    }
    contacts.resize(kept);
  };
  for (auto* contacts : {&walls_, &pairs_, &dormant_walls_, &dormant_pairs_}) update(*contacts);
}

template <class Real>
void IceContacts<Real>::findWalls(const IceBodies<Real>& bodies) {
  std::array<Face, 6> faces;
  for (Index b = 0; b < bodies.count(); ++b) {
    const IceBody& body = bodies.body(b);
    if (body.held()) continue;
    near_.clear();
    for (std::size_t k = 0; k < faces_.count(); ++k) {
      const double reach = body.radius_m + margin_m_;
      if (faces_.near(k, body.pose.centre_m, body.next.centre_m, reach)) {
        near_.push_back(static_cast<Index>(k));
      }
    }
    if (near_.empty()) continue;
    const bool solid = body.solid != kNone;
    for (Index m = body.first; m < body.surface_last; ++m) {
      const Vec3d from = body.pose.at(bodies.offset(m)), to = body.next.at(bodies.offset(m));
      for (const Index k : near_) {
        const std::size_t count = faces_.find(k, from, to, margin_m_, faces);
        for (std::size_t f = 0; f < count; ++f) {
          const std::uint64_t key = (std::uint64_t(m) << 32) | (k * 8 + faces[f].number);
          walls_.push_back({key, b, kNone, m, kNone, k, faces[f].normal, faces[f].point,
                            faces[f].gap_m, faces[f].before_m,
                            solid ? solid_friction_[body.solid] : faces_.friction(k)});
        }
      }
    }
  }
}

template <class Real>
void IceContacts<Real>::findCandidates(const IceBodies<Real>& bodies,
                                       const VectorField<Real>& predicted,
                                       const Neighbours<Real>& neighbours) {
  candidates_.clear();
  if (bodies.count() < 2) return;
  const double reach = std::hypot(1.0, kBeside) * contact_m_ + margin_m_ + kApproach_d * spacing_m_;
  const Real reach2 = static_cast<Real>(reach * reach);
  for (Index b = 0; b < bodies.count(); ++b) {
    const IceBody& body = bodies.body(b);
    for (Index m = body.first; m < body.surface_last; ++m) {
      const Index i = bodies.placeOf(m);
      const Vec3<Real> at = predicted.at(i);
      const std::size_t first = candidates_.size();
      for (const Index j : neighbours.of(i)) {
        const Index other = bodies.memberAt(j);
        if (other == kNone || other < body.last) continue;
        if ((predicted.at(j) - at).squaredNorm() > reach2 || !bodies.atSurface(other)) continue;
        candidates_.push_back({m, other});
      }
      // In the order of the members, not of the particles.
      std::sort(candidates_.begin() + std::ptrdiff_t(first), candidates_.end(),
                [](const Candidate& s, const Candidate& t) { return s.b < t.b; });
    }
  }
}

/// Direction in which member b pushes member a, or zero if they do not touch. If one of them lies
/// in a face, it is the normal of that face: with the line between the members as normal, faces
/// would be bumpy and interlock.
/// @param bare_a, bare_b IceBodies::outward in world axes
/// @param now, before from b to a, m
template <class Real>
Vec3d IceContacts<Real>::normalBetween(const Vec3d& bare_a, const Vec3d& bare_b, const Vec3d& now,
                                       const Vec3d& before) const {
  const double a = bare_a.norm(), b = bare_b.norm();
  Vec3d face = Vec3d::Zero();
  if (b > 0 && b < kFlatter * a) {
    face = bare_b;
  } else if (a > 0 && a < kFlatter * b) {
    face = -bare_a;
  } else if (a > 0 && b > 0) {
    face = bare_b / b - bare_a / a;
  }
  const double size = face.norm();
  if (size > 0.2) {
    face /= size;
    const double height = face.dot(now);
    const double beside = kBeside * contact_m_;
    const bool above = (now - height * face).squaredNorm() < beside * beside;
    if (above && face.dot(before) > 0)
      return height < contact_m_ + margin_m_ ? face : Vec3d::Zero();
  }
  const double reach = contact_m_ + margin_m_;
  if (now.squaredNorm() >= reach * reach) return Vec3d::Zero();
  // Members that passed through each other separate in the direction they came from.
  const Vec3d line = now.dot(before) > 0 ? now : before;
  const double length = line.norm();
  return length < kCoincident_d * spacing_m_ ? Vec3d::UnitZ() : Vec3d(line / length);
}

template <class Real>
void IceContacts<Real>::addPair(const IceBodies<Real>& bodies, const Candidate& candidate) {
  const Index ka = bodies.bodyOfMember(candidate.a), kb = bodies.bodyOfMember(candidate.b);
  const IceBody& a = bodies.body(ka);
  const IceBody& b = bodies.body(kb);
  if (a.held() && b.held()) return;
  const Vec3d& qa = bodies.offset(candidate.a);
  const Vec3d& qb = bodies.offset(candidate.b);
  const Vec3d now = a.next.at(qa) - b.next.at(qb);
  const Vec3d before = a.pose.at(qa) - b.pose.at(qb);
  const Vec3d normal =
      normalBetween(a.next.rotation_matrix * bodies.outward(candidate.a),
                    b.next.rotation_matrix * bodies.outward(candidate.b), now, before);
  if (normal.isZero(0)) return;
  const std::uint64_t key = (std::uint64_t(candidate.a) << 32) | candidate.b;
  pairs_.push_back({key, ka, kb, candidate.a, candidate.b, kNone, normal, Vec3d::Zero(),
                    normal.dot(now) - contact_m_, normal.dot(before) - contact_m_,
                    frictionBetween(a, b)});
}

/// Copies the multipliers of contacts that existed in the latest substep. Both lists are ascending.
template <class Real>
void IceContacts<Real>::startWarm(std::vector<Contact>& contacts,
                                  const std::vector<Contact>& before, double ratio) {
  std::size_t k = 0;
  for (Contact& contact : contacts) {
    while (k < before.size() && before[k].key < contact.key) ++k;
    if (k == before.size()) return;
    if (before[k].key != contact.key || before[k].swept) continue;
    contact.normal_multiplier = ratio * before[k].normal_multiplier;
    contact.friction_multiplier = ratio * before[k].friction_multiplier;
  }
}

/// Stores the loads of sleeping bodies, so that they wake in equilibrium.
template <class Real>
void IceContacts<Real>::layDown(const IceBodies<Real>& bodies, const std::vector<Contact>& before,
                                std::vector<Contact>& dormant) {
  const auto awake = [&](const Contact& contact) {
    return !bodies.body(contact.a).held() || (contact.b != kNone && !bodies.body(contact.b).held());
  };
  dormant.erase(std::remove_if(dormant.begin(), dormant.end(), awake), dormant.end());
  const std::size_t slept = dormant.size();
  for (const Contact& contact : before) {
    if (contact.normal_multiplier > 0 && !awake(contact)) dormant.push_back(contact);
  }
  if (dormant.size() == slept) return;
  std::sort(dormant.begin(), dormant.end(),
            [](const Contact& a, const Contact& b) { return a.key < b.key; });
}

template <class Real>
std::size_t IceContacts<Real>::bytes() const {
  const std::size_t contacts = walls_.capacity() + pairs_.capacity() + old_walls_.capacity() +
                               old_pairs_.capacity() + swept_.capacity() +
                               dormant_walls_.capacity() + dormant_pairs_.capacity();
  return contacts * sizeof(Contact) + rows_.capacity() * sizeof(Rows) +
         moves_.capacity() * sizeof(Move) + found_.capacity() * sizeof(Placement) +
         candidates_.capacity() * sizeof(Candidate) +
         (near_.capacity() + carrier_.capacity()) * sizeof(Index) + out_.capacity() +
         stays_.capacity() + solid_friction_.capacity() * sizeof(double) +
         face_.capacity() * sizeof(std::size_t) + plane_.capacity() * sizeof(Vec3d);
}

template class IceContacts<float>;
template class IceContacts<double>;

}  // namespace ice_ice_baby
