// Swept contacts between ice bodies so fast that they would pass through each other within a
// substep. Neighbour lists at the end of the substep do not contain them.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// Relative motion per substep, in spacings, up to which the neighbour lists suffice.
constexpr double kFast_d = 0.5;

/// Members that touch within this further motion, in spacings, count as hit too.
constexpr double kTogether_d = 0.1;

/// Upper bound of the distance that any member moves in the substep, m.
double travel(const IceBody& body) {
  return (body.next.centre_m - body.pose.centre_m).norm() +
         (body.next.rotation_matrix - body.pose.rotation_matrix).norm() * body.radius_m;
}

/// Fraction of a straight path at which it comes within `reach_m` of the origin; 2 if it never does
/// or starts inside.
double meets(const Vec3d& from, const Vec3d& to, double reach_m) {
  const Vec3d way = to - from;
  const double b = from.dot(way);
  if (b >= 0) return 2.0;
  const double a = way.squaredNorm(), c = from.squaredNorm() - reach_m * reach_m;
  if (c <= 0) return 0.0;
  const double root = b * b - a * c;
  return root < 0 ? 2.0 : (-b - std::sqrt(root)) / a;
}

/// Centre of a body during the substep.
Vec3d centreAt(const IceBody& body, double share) {
  return body.pose.centre_m + share * (body.next.centre_m - body.pose.centre_m);
}

}  // namespace

/// Pairs whose swept spheres overlap along x, at least one of the two being fast.
template <class Real>
void IceContacts<Real>::findSwept(IceBodies<Real>& bodies) {
  swept_.clear();
  const double fast_m = kFast_d * spacing_m_;
  std::vector<char> fast(bodies.count());
  for (Index b = 0; b < bodies.count(); ++b) fast[b] = travel(bodies.body(b)) > fast_m;
  if (bodies.count() < 2 || std::find(fast.begin(), fast.end(), 1) == fast.end()) return;
  const double half = contact_m_ / 2;
  const auto low = [&](Index b) {
    const IceBody& body = bodies.body(b);
    return std::min(body.pose.centre_m.x(), body.next.centre_m.x()) - body.radius_m - half;
  };
  const auto high = [&](Index b) {
    const IceBody& body = bodies.body(b);
    return std::max(body.pose.centre_m.x(), body.next.centre_m.x()) + body.radius_m + half;
  };
  std::vector<Index> by_x(bodies.count());
  std::iota(by_x.begin(), by_x.end(), Index(0));
  std::sort(by_x.begin(), by_x.end(), [&](Index a, Index b) { return low(a) < low(b); });
  for (auto a = by_x.begin(); a != by_x.end(); ++a) {
    const double end = high(*a);
    for (auto b = a + 1; b != by_x.end() && low(*b) <= end; ++b) {
      if (fast[*a] || fast[*b]) sweepPair(bodies, std::min(*a, *b), std::max(*a, *b));
    }
  }
}

/// Adds the pair of members of two bodies that meets first.
template <class Real>
void IceContacts<Real>::sweepPair(IceBodies<Real>& bodies, Index ka, Index kb) {
  const IceBody& a = bodies.body(ka);
  const IceBody& b = bodies.body(kb);
  if (a.carried() && b.carried()) return;
  const Vec3d before = a.pose.centre_m - b.pose.centre_m, after = a.next.centre_m - b.next.centre_m;
  const double reach = a.radius_m + b.radius_m + contact_m_;
  const double nearest = before.norm() <= reach ? 0.0 : meets(before, after, reach);
  if (nearest > 1) return;

  const std::size_t first = swept_.size();
  double soonest = 1.0;
  for (Index m = a.first; m < a.surface_last; ++m) {
    const Vec3d from = a.pose.at(bodies.offset(m)), to = a.next.at(bodies.offset(m));
    const double near_b = b.radius_m + contact_m_;
    const Vec3d start = from - b.pose.centre_m;
    if (start.norm() > near_b && meets(start, to - b.next.centre_m, near_b) > 1) continue;
    for (Index n = b.first; n < b.surface_last; ++n) {
      const Vec3d was = from - b.pose.at(bodies.offset(n)), is = to - b.next.at(bodies.offset(n));
      const double way = (is - was).norm();
      if (way < kFast_d * spacing_m_) continue;
      const double met = meets(was, is, contact_m_);
      const double slack = kTogether_d * spacing_m_ / way;
      if (met > soonest + slack) continue;
      soonest = std::min(soonest, met);
      const Vec3d line = was + met * (is - was);
      if (line.norm() < 1e-6 * spacing_m_) continue;
      const Vec3d normal = line.normalized();
      const Vec3d touch = from + met * (to - from) - line / 2;
      Contact contact{(std::uint64_t(m) << 32) | n,
                      ka,
                      kb,
                      m,
                      n,
                      kNone,
                      normal,
                      Vec3d::Zero(),
                      normal.dot(is) - contact_m_,
                      normal.dot(was) - contact_m_,
                      0.0};
      contact.swept = true;
      contact.met = met;
      contact.arm_a = touch - centreAt(a, met);
      contact.arm_b = touch - centreAt(b, met);
      swept_.push_back(contact);
    }
  }
  const auto late = [&](const Contact& contact) {
    return contact.met > soonest + kTogether_d * spacing_m_ / (after - before).norm();
  };
  swept_.erase(std::remove_if(swept_.begin() + std::ptrdiff_t(first), swept_.end(), late),
               swept_.end());
  if (swept_.size() == first) return;
  if (a.asleep) bodies.wakeInFlight(ka);
  if (b.asleep) bodies.wakeInFlight(kb);
}

/// Adds the swept contacts to the list, replacing the ones found at the end of the path.
template <class Real>
void IceContacts<Real>::addSwept() {
  if (swept_.empty()) return;
  const auto before = [](const Contact& s, const Contact& t) { return s.key < t.key; };
  std::sort(swept_.begin(), swept_.end(), before);
  const auto again = [&](const Contact& contact) {
    return std::any_of(swept_.begin(), swept_.end(), [&](const Contact& swept) {
      return swept.a == contact.a && swept.b == contact.b;
    });
  };
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), again), pairs_.end());
  const std::ptrdiff_t known = std::ptrdiff_t(pairs_.size());
  pairs_.insert(pairs_.end(), swept_.begin(), swept_.end());
  std::inplace_merge(pairs_.begin(), pairs_.begin() + known, pairs_.end(), before);
}

/// Overlapping bodies that rotate far in a substep can require unphysical displacements. Scales the
/// impulses of an island with a swept contact so that its kinetic energy does not rise. Each
/// impulse acts on two bodies at one point, so both momenta are conserved. Moving colliders may do
/// work.
template <class Real>
void IceContacts<Real>::boundEnergy(const IceBodies<Real>& bodies) {
  const auto islandOf = [&](const Contact& contact) {
    const bool other = bodies.body(contact.a).held() && contact.b != kNone;
    return bodies.body(other ? contact.b : contact.a).island;
  };
  const auto moves = [&](const Contact& contact) {
    if (contact.b == kNone) return faces_.moves(contact.collider);
    return bodies.body(contact.a).carried() || bodies.body(contact.b).carried();
  };
  std::vector<char> bound(bodies.count(), 0);
  for (const Contact& contact : pairs_) {
    if (contact.swept) bound[islandOf(contact)] = 1;
  }
  for (std::size_t k = 0; k < count(); ++k) {
    if (moves(contactAt(k))) bound[islandOf(contactAt(k))] = 0;
  }

  // The energy is quadratic in the scale s of the impulses: s linear + s^2 square / 2.
  std::vector<double> linear(bodies.count(), 0.0), square(bodies.count(), 0.0);
  for (Index b = 0; b < bodies.count(); ++b) {
    const IceBody& body = bodies.body(b);
    if (!moves_[b].touched || body.held()) continue;
    const Move& move = moves_[b];
    const Vec3d spun = body.next.rotation_matrix *
                       (body.inertia * (body.next.rotation_matrix.transpose() * move.rotation));
    linear[body.island] += bodies.dt_s() * (body.mass_kg * body.velocity_m_s.dot(move.by) +
                                            body.angularVelocity().dot(spun));
    square[body.island] += body.mass_kg * move.by.squaredNorm() + move.rotation.dot(spun);
  }
  const auto share = [&](Index island) {
    if (!bound[island] || linear[island] + square[island] / 2 <= 0) return 1.0;
    return std::max(0.0, -linear[island] / square[island]);
  };
  for (Index b = 0; b < bodies.count(); ++b) {
    moves_[b].by *= share(bodies.body(b).island);
    moves_[b].rotation *= share(bodies.body(b).island);
  }
  for (std::size_t k = 0; k < count(); ++k) {
    Contact& contact = contactAt(k);
    const double s = share(islandOf(contact));
    const Vec3d& given = rows_[k].given;
    const double pressing = given.dot(contact.normal);
    contact.friction_multiplier =
        s * contact.friction_multiplier + (1 - s) * (given - pressing * contact.normal);
    contact.normal_multiplier = s * contact.normal_multiplier + (1 - s) * pressing;
  }
}

template void IceContacts<float>::findSwept(IceBodies<float>&);
template void IceContacts<double>::findSwept(IceBodies<double>&);
template void IceContacts<float>::addSwept();
template void IceContacts<double>::addSwept();
template void IceContacts<float>::boundEnergy(const IceBodies<float>&);
template void IceContacts<double>::boundEnergy(const IceBodies<double>&);

}  // namespace ice_ice_baby
