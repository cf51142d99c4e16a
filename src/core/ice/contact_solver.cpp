// Projected Gauss-Seidel over the contacts of ice bodies.
#include <algorithm>
#include <cmath>

#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// Maximum number of sweeps per solve, half of them forwards and half backwards.
constexpr int kSweeps = 10;

/// The same if bodies would pass through each other, where the error is larger.
constexpr int kSweptSweeps = 200;

/// Sweeping stops once no body moves by more than this, in spacings.
constexpr double kSettled_d = 1e-7;

/// Initial overlap is resolved by this fraction per substep, and no faster than this speed, because
/// the correction counts as velocity.
constexpr double kRelease = 0.2;
constexpr double kRelease_m_s = 0.1;

/// Gap that a contact must keep: zero, or most of the overlap that it started with.
double allowedGap(double before_m, double dt_s) {
  if (before_m >= 0) return 0.0;
  return before_m + std::min(-kRelease * before_m, kRelease_m_s * dt_s);
}

}  // namespace

template <class Real>
void IceContacts<Real>::makeRows(const IceBodies<Real>& bodies, const Contact& contact,
                                 Rows& rows) const {
  const bool wall = contact.b == kNone;
  const IceBody& a = bodies.body(contact.a);
  const IceBody& b = bodies.body(wall ? contact.a : contact.b);
  rows.a = contact.a;
  rows.b = contact.b;
  rows.mass_a = a.held() ? 0.0 : 1.0 / a.mass_kg;
  rows.mass_b = wall || b.held() ? 0.0 : 1.0 / b.mass_kg;
  const Vec3d at_a = a.next.at(bodies.offset(contact.member_a));
  const Vec3d at_b = wall ? contact.point : b.next.at(bodies.offset(contact.member_b));
  // Both bodies receive the impulse at the same point, so angular momentum is conserved.
  const Vec3d touch =
      wall ? Vec3d(at_a - spacing_m_ / 2 * contact.normal) : Vec3d((at_a + at_b) / 2);
  const Vec3d arm_a = contact.swept ? contact.arm_a : Vec3d(touch - a.next.centre_m);
  const Vec3d arm_b = wall            ? Vec3d::Zero()
                      : contact.swept ? contact.arm_b
                                      : Vec3d(touch - b.next.centre_m);
  const double gap = contact.normal.dot(at_a - at_b) - (wall ? 0.0 : contact_m_);

  // How far the two surfaces have slid since the start of the substep.
  const auto began = [&](Index k, const IceBody& body, const Vec3d& arm) -> Vec3d {
    return body.pose.centre_m + moves_[k].back * arm;
  };
  const Motion<double>* motion = wall ? &faces_.motion(contact.collider) : nullptr;
  const Vec3d other_began =
      wall ? motion->from.toWorld(motion->to.toLocal(touch)) : began(contact.b, b, arm_b);
  const Vec3d slid = other_began - began(contact.a, a, arm_a);
  const auto fill = [&](Row& row, const Vec3d& axis, double value) {
    row.axis = axis;
    row.lever_a = arm_a.cross(axis);
    row.lever_b = arm_b.cross(axis);
    row.rotation_a = rows.mass_a > 0 ? Vec3d(a.mobility_now * row.lever_a) : Vec3d::Zero();
    row.rotation_b = rows.mass_b > 0 ? Vec3d(b.mobility_now * row.lever_b) : Vec3d::Zero();
    row.inverse_mass = rows.mass_a + rows.mass_b + row.lever_a.dot(row.rotation_a) +
                       row.lever_b.dot(row.rotation_b);
    row.value_m = value;
  };
  const Vec3d first = contact.normal.unitOrthogonal();
  const Vec3d second = contact.normal.cross(first);
  fill(rows.normal, contact.normal, gap - allowedGap(contact.before_m, bodies.dt_s()));
  fill(rows.first, first, first.dot(slid));
  fill(rows.second, second, second.dot(slid));
}

template <class Real>
void IceContacts<Real>::apply(const Rows& rows, const Row& row, double multiplier) {
  Move& a = moves_[rows.a];
  a.by += (rows.mass_a * multiplier) * row.axis;
  a.rotation += multiplier * row.rotation_a;
  if (rows.b == kNone) return;
  Move& b = moves_[rows.b];
  b.by -= (rows.mass_b * multiplier) * row.axis;
  b.rotation -= multiplier * row.rotation_b;
}

template <class Real>
double IceContacts<Real>::violation(const Rows& rows, const Row& row) const {
  const Move& a = moves_[rows.a];
  double value = row.value_m + row.axis.dot(a.by) + row.lever_a.dot(a.rotation);
  if (rows.b == kNone) return value;
  const Move& b = moves_[rows.b];
  return value - row.axis.dot(b.by) - row.lever_b.dot(b.rotation);
}

/// Solves one contact: the normal first, then friction within its cone.
/// @return the largest displacement that it caused, m
template <class Real>
double IceContacts<Real>::relax(const Rows& rows, Contact& contact) {
  const Row& normal = rows.normal;
  const double wanted = contact.normal_multiplier - violation(rows, normal) / normal.inverse_mass;
  const double pressing = std::max(0.0, wanted);
  double moved = std::abs(pressing - contact.normal_multiplier) * normal.inverse_mass;
  if (pressing != contact.normal_multiplier)
    apply(rows, normal, pressing - contact.normal_multiplier);
  contact.normal_multiplier = pressing;
  if (contact.friction == 0 || (pressing == 0 && contact.friction_multiplier.isZero(0)))
    return moved;

  const double before_first = contact.friction_multiplier.dot(rows.first.axis);
  const double before_second = contact.friction_multiplier.dot(rows.second.axis);
  double first = before_first - violation(rows, rows.first) / rows.first.inverse_mass;
  double second = before_second - violation(rows, rows.second) / rows.second.inverse_mass;
  const double max = contact.friction * pressing;
  const double size = std::hypot(first, second);
  if (size > max) {
    first *= max / size;
    second *= max / size;
  }
  apply(rows, rows.first, first - before_first);
  apply(rows, rows.second, second - before_second);
  contact.friction_multiplier = first * rows.first.axis + second * rows.second.axis;
  moved = std::max(moved, std::abs(first - before_first) * rows.first.inverse_mass);
  return std::max(moved, std::abs(second - before_second) * rows.second.inverse_mass);
}

/// A centre ends at c + dt v, so an impulse changes the orbital angular momentum at the position at
/// the start of the substep, but the rotation at the present contact point. The relative motion of
/// two bodies in between is a lever arm that would create angular momentum; each body compensates
/// half of it.
template <class Real>
void IceContacts<Real>::levelMomenta(IceBodies<Real>& bodies) {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Contact& contact = pairs_[k];
    IceBody& a = bodies.body(contact.a);
    IceBody& b = bodies.body(contact.b);
    if (a.held() || b.held()) continue;
    const Vec3d given = contact.normal_multiplier * contact.normal + contact.friction_multiplier -
                        rows_[walls_.size() + k].given;
    const Vec3d passed = (a.next.centre_m - a.pose.centre_m) - (b.next.centre_m - b.pose.centre_m);
    const Vec3d angular_impulse = contact.met * passed.cross(given) / (2 * bodies.dt_s());
    a.angular_momentum += angular_impulse;
    b.angular_momentum += angular_impulse;
  }
}

/// Resets the moves of the bodies and stores the present rotation of those with contacts.
template <class Real>
void IceContacts<Real>::beginMoves(const IceBodies<Real>& bodies) {
  moves_.assign(bodies.count(), Move());
  const auto touch = [&](Index b) {
    if (b == kNone || moves_[b].touched) return;
    const IceBody& body = bodies.body(b);
    moves_[b].back = body.pose.rotation_matrix * body.next.rotation_matrix.transpose();
    moves_[b].touched = true;
  };
  for (std::size_t k = 0; k < count(); ++k) {
    touch(contactAt(k).a);
    touch(contactAt(k).b);
  }
}

/// Applies the multipliers of the latest substep as a warm start.
template <class Real>
void IceContacts<Real>::applyWarm(const Rows& rows, Contact& contact) {
  apply(rows, rows.normal, contact.normal_multiplier);
  const double first = contact.friction_multiplier.dot(rows.first.axis);
  const double second = contact.friction_multiplier.dot(rows.second.axis);
  contact.friction_multiplier = first * rows.first.axis + second * rows.second.axis;
  apply(rows, rows.first, first);
  apply(rows, rows.second, second);
}

/// Marks bodies that rest on something immovable, and groups bodies in contact.
template <class Real>
void IceContacts<Real>::noteLoads(IceBodies<Real>& bodies) {
  for (Index b = 0; b < bodies.count(); ++b) {
    bodies.body(b).supported = false;
    bodies.body(b).island = b;
  }
  const auto root = [&](Index b) {
    while (bodies.body(b).island != b) {
      b = bodies.body(b).island = bodies.body(bodies.body(b).island).island;
    }
    return b;
  };
  for (std::size_t k = 0; k < count(); ++k) {
    const Contact& contact = contactAt(k);
    if (contact.normal_multiplier == 0) continue;
    IceBody& a = bodies.body(contact.a);
    const bool wall = contact.b == kNone;
    if (wall || bodies.body(contact.b).held()) {
      a.supported = true;
    } else if (a.held()) {
      bodies.body(contact.b).supported = true;
    } else {
      const Index one = root(contact.a), other = root(contact.b);
      bodies.body(std::max(one, other)).island = std::min(one, other);
    }
  }
  for (Index b = 0; b < bodies.count(); ++b) bodies.body(b).island = root(b);
}

template <class Real>
void IceContacts<Real>::solve(IceBodies<Real>& bodies, VectorField<Real>& predicted) {
  const std::size_t contacts = count();
  beginMoves(bodies);
  rows_.resize(contacts);
  for (std::size_t k = 0; k < contacts; ++k) {
    Contact& contact = contactAt(k);
    Rows& rows = rows_[k];
    makeRows(bodies, contact, rows);
    rows.given =
        warm_ ? Vec3d::Zero()
              : Vec3d(contact.normal_multiplier * contact.normal + contact.friction_multiplier);
    if (warm_) applyWarm(rows, contact);
  }
  warm_ = false;
  const int sweeps = swept_.empty() ? kSweeps : kSweptSweeps;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double moved = 0.0;
    for (std::size_t k = 0; k < contacts; ++k) {
      const std::size_t at = sweep % 2 == 0 ? k : contacts - 1 - k;
      moved = std::max(moved, relax(rows_[at], contactAt(at)));
    }
    if (moved < kSettled_d * spacing_m_) break;
  }
  noteLoads(bodies);
  if (!swept_.empty()) boundEnergy(bodies);
  levelMomenta(bodies);
  for (Index b = 0; b < bodies.count(); ++b) {
    IceBody& body = bodies.body(b);
    if (!moves_[b].touched || body.held()) continue;
    body.push(moves_[b].by, moves_[b].rotation, bodies.dt_s());
  }
  bodies.writePredicted(predicted, false);
}

template class IceContacts<float>;
template class IceContacts<double>;

}  // namespace ice_ice_baby
