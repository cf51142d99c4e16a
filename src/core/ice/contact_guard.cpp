// Moves bodies back that the contact solver left deep inside a collider.
#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// Penetration, in spacings, beyond which a member could pass through a wall.
constexpr double kDeep_d = 0.4;

/// A body on which a collider landed is pushed out at most this often, until its penetration is
/// below this depth, in spacings.
constexpr int kMaxPushes = 32;
constexpr double kTouch_d = 0.05;

}  // namespace

/// Initial penetration may persist but must not grow. True for NaN.
template <class Real>
bool IceContacts<Real>::deepInside(const IceBodies<Real>& bodies, const Contact& contact) const {
  const Vec3d x = bodies.body(contact.a).next.at(bodies.offset(contact.member_a));
  const double gap = contact.normal.dot(x - contact.point);
  return !(gap > -kDeep_d * spacing_m_ || gap > contact.before_m - 1e-3 * spacing_m_);
}

/// Upper bound of the distance that any member moved since contacts were found. Members without a
/// contact were farther than the margin from every face.
template <class Real>
double IceContacts<Real>::movedSinceFound(const IceBody& body, Index b) const {
  return (body.next.centre_m - found_[b].centre_m).norm() +
         (body.next.rotation_matrix - found_[b].rotation_matrix).norm() * body.radius_m;
}

/// Marks a body to be moved back, and the collider that carries it.
template <class Real>
void IceContacts<Real>::markOut(Index b, Index collider) {
  out_[b] = 1;
  if (collider == kNone || !faces_.moves(collider)) return;
  // Containers take precedence, as for water.
  if (carrier_[b] == kNone || !faces_.hollow(carrier_[b])) carrier_[b] = collider;
}

/// Checks every member of a body that moved farther than its contacts account for.
template <class Real>
void IceContacts<Real>::checkAll(const IceBodies<Real>& bodies, Index b) {
  const IceBody& body = bodies.body(b);
  const double deep = kDeep_d * spacing_m_;
  for (std::size_t k = 0; k < faces_.count(); ++k) {
    const double reach = body.radius_m + deep;
    if (!faces_.near(k, body.pose.centre_m, body.next.centre_m, reach)) continue;
    for (Index m = body.first; m < body.surface_last; ++m) {
      const Vec3d from = body.pose.at(bodies.offset(m)), to = body.next.at(bodies.offset(m));
      if (faces_.push(k, from, to).squaredNorm() <= deep * deep) continue;
      markOut(b, static_cast<Index>(k));
      break;
    }
  }
}

template <class Real>
void IceContacts<Real>::contain(IceBodies<Real>& bodies, VectorField<Real>& predicted) {
  out_.assign(bodies.count(), 0);
  carrier_.assign(bodies.count(), kNone);
  for (const Contact& contact : walls_) {
    if (deepInside(bodies, contact)) markOut(contact.a, contact.collider);
  }
  bool any = false;
  for (Index b = 0; b < bodies.count(); ++b) {
    const IceBody& body = bodies.body(b);
    if (body.held()) continue;
    if (!body.next.allFinite()) {
      markOut(b, kNone);
    } else if (movedSinceFound(body, b) > kDeep_d * spacing_m_ + margin_m_) {
      checkAll(bodies, b);
    }
    if (out_[b]) putBack(bodies, b);
    any = any || out_[b];
  }
  if (any) bodies.writePredicted(predicted, false);
}

template <class Real>
void IceContacts<Real>::putBack(IceBodies<Real>& bodies, Index b) {
  IceBody& body = bodies.body(b);
  Placement place = body.pose;
  if (carrier_[b] != kNone) {
    const Motion<double>& motion = faces_.motion(carrier_[b]);
    const Mat3<double> rotation = motion.to.rotation * motion.from.rotation.transpose();
    place = {motion.to.toWorld(motion.from.toLocal(body.pose.centre_m)),
             Eigen::Quaterniond(rotation) * body.pose.rotation};
  }
  body.moveTo(place);
  body.stop();
  ++limited_;
}

/// Largest push of the colliders on the members of a body, m.
template <class Real>
Vec3d IceContacts<Real>::longestPush(const IceBodies<Real>& bodies, Index b) const {
  const IceBody& body = bodies.body(b);
  Vec3d longest = Vec3d::Zero();
  for (std::size_t k = 0; k < faces_.count(); ++k) {
    if (!faces_.near(k, body.pose.centre_m, body.pose.centre_m, body.radius_m)) continue;
    for (Index m = body.first; m < body.surface_last; ++m) {
      const Vec3d x = body.pose.at(bodies.offset(m));
      const Vec3d push = faces_.push(k, x, x);
      if (push.squaredNorm() > longest.squaredNorm()) longest = push;
    }
  }
  return longest;
}

template <class Real>
void IceContacts<Real>::expel(IceBodies<Real>& bodies, const Colliders<Real>& colliders) {
  faces_.take(colliders);
  for (Index b = 0; b < bodies.count(); ++b) {
    IceBody& body = bodies.body(b);
    if (body.carried()) continue;
    for (int pass = 0; pass < kMaxPushes; ++pass) {
      const Vec3d push = longestPush(bodies, b);
      if (push.norm() < kTouch_d * spacing_m_) break;
      body.moveTo({body.pose.centre_m + push, body.pose.rotation});
      body.pose = body.next;
    }
  }
}

template void IceContacts<float>::expel(IceBodies<float>&, const Colliders<float>&);
template void IceContacts<double>::expel(IceBodies<double>&, const Colliders<double>&);
template void IceContacts<float>::contain(IceBodies<float>&, VectorField<float>&);
template void IceContacts<double>::contain(IceBodies<double>&, VectorField<double>&);

}  // namespace ice_ice_baby
