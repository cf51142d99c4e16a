// The few contacts that a body needs where it lies flat on something.
#include <array>
#include <cmath>
#include <limits>

#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// A face with no more contacts than this keeps them all.
constexpr std::size_t kFew = 12;

/// Normals nearer than this are those of one face.
constexpr double kParallel = 1 - 1e-6;

/// So many faces of a body are looked at; a body on a round collider has a normal for each contact.
constexpr int kMostFaces = 16;

/// The member that would come down first if the body tilted by so much in one of the directions;
/// flat: that reaches furthest.
constexpr std::array<double, 3> kTilts{0.003, 0.03, 1e6};
constexpr int kDirections = 8;

}  // namespace

/// A body on a flat face is held by the corners of what touches it, so one that rests on hundreds
/// of members needs a handful of contacts. What is deepest, what would come down first at a tilt
/// and what bore a load in the latest substep stay; the others go.
template <class Real>
void IceContacts<Real>::keepSupports(const IceBodies<Real>& bodies,
                                     std::vector<Contact>& contacts) {
  std::size_t kept = 0;
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last) {
    while (last < contacts.size() && contacts[last].a == contacts[first].a) ++last;
    stays_.assign(last - first, last - first > kFew ? kOpen : kStays);
    for (int face = 0; face < kMostFaces && last - first > kFew; ++face) {
      if (!keepFace(bodies, contacts, first, last)) break;
    }
    for (std::size_t k = first; k < last; ++k) {
      if (stays_[k - first] != kDropped) contacts[kept++] = contacts[k];
    }
  }
  contacts.resize(kept);
}

/// Decides on the contacts of one face among contacts first ... last - 1 of one body.
/// @return whether there was one left
template <class Real>
bool IceContacts<Real>::keepFace(const IceBodies<Real>& bodies,
                                 const std::vector<Contact>& contacts, std::size_t first,
                                 std::size_t last) {
  std::size_t seed = first;
  while (seed < last && stays_[seed - first] != kOpen) ++seed;
  if (seed == last) return false;
  const Contact& one = contacts[seed];
  face_.clear();
  for (std::size_t k = seed; k < last; ++k) {
    const Contact& other = contacts[k];
    if (stays_[k - first] != kOpen || other.b != one.b || other.collider != one.collider) continue;
    if (other.normal.dot(one.normal) < kParallel) continue;
    const bool bears = other.normal_multiplier > 0;
    stays_[k - first] = bears ? kStays : kDropped;
    face_.push_back(k);
  }
  if (face_.size() <= kFew) {
    for (const std::size_t k : face_) stays_[k - first] = kStays;
    return true;
  }
  const IceBody& body = bodies.body(one.a);
  const Vec3d along = one.normal.unitOrthogonal(), across = one.normal.cross(along);
  plane_.clear();
  for (const std::size_t k : face_) {
    const Vec3d arm = body.next.turn * bodies.offset(contacts[k].member_a);
    plane_.push_back({along.dot(arm), across.dot(arm), contacts[k].gap_m});
  }
  const auto keepFurthest = [&](const Vec3d& direction) {
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < plane_.size(); ++k) {
      const double score = direction.dot(plane_[k]);
      if (score > most) {
        most = score;
        best = k;
      }
    }
    stays_[face_[best] - first] = kStays;
  };
  keepFurthest({0, 0, -1});
  for (const double tilt : kTilts) {
    for (int k = 0; k < kDirections; ++k) {
      // Off the axes of lattices, along whose edges many would be the furthest.
      const double angle = 2 * M_PI * (k + 0.3) / kDirections;
      keepFurthest({tilt * std::cos(angle), tilt * std::sin(angle), -1});
    }
  }
  return true;
}

template void IceContacts<float>::keepSupports(const IceBodies<float>&, std::vector<Contact>&);
template void IceContacts<double>::keepSupports(const IceBodies<double>&, std::vector<Contact>&);

}  // namespace ice_ice_baby
