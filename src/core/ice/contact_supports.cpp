// Reduces the contacts of a body that lies flat on a surface to the few that it needs.
#include <array>
#include <cmath>
#include <limits>

#include "ice/ice_contacts.h"

namespace ice_ice_baby {

namespace {

/// A face with at most this many contacts keeps them all.
constexpr std::size_t kFew = 12;

/// Normals closer than this belong to the same face.
constexpr double kParallel = 1 - 1e-6;

/// Maximum number of faces per body. On a round collider every contact has its own normal.
constexpr int kMaxFaces = 16;

/// Tilts of the body at which the first member to touch is kept; with no tilt, the farthest member.
constexpr std::array<double, 3> kTilts{0.003, 0.03, 1e6};
constexpr int kDirections = 8;

}  // namespace

/// A body on a flat face is supported by the corners of its contact area, so a body that rests on
/// hundreds of members needs only a few contacts. Keeps the deepest contact, those that would touch
/// first at a tilt, and those that carried a load in the latest substep.
template <class Real>
void IceContacts<Real>::keepSupports(const IceBodies<Real>& bodies,
                                     std::vector<Contact>& contacts) {
  std::size_t kept = 0;
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last) {
    while (last < contacts.size() && contacts[last].a == contacts[first].a) ++last;
    stays_.assign(last - first, last - first > kFew ? kOpen : kStays);
    for (int face = 0; face < kMaxFaces && last - first > kFew; ++face) {
      if (!keepFace(bodies, contacts, first, last)) break;
    }
    for (std::size_t k = first; k < last; ++k) {
      if (stays_[k - first] != kDropped) contacts[kept++] = contacts[k];
    }
  }
  contacts.resize(kept);
}

/// Selects the contacts of one face among contacts first ... last - 1 of one body.
/// @return false if no undecided contact was left
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
    const Vec3d arm = body.next.rotation_matrix * bodies.offset(contacts[k].member_a);
    plane_.push_back({along.dot(arm), across.dot(arm), contacts[k].gap_m});
  }
  const auto keepFarthest = [&](const Vec3d& direction) {
    std::size_t best = 0;
    double max = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < plane_.size(); ++k) {
      const double score = direction.dot(plane_[k]);
      if (score > max) {
        max = score;
        best = k;
      }
    }
    stays_[face_[best] - first] = kStays;
  };
  keepFarthest({0, 0, -1});
  for (const double tilt : kTilts) {
    for (int k = 0; k < kDirections; ++k) {
      // Directions off the lattice axes, along which many members would tie.
      const double angle = 2 * M_PI * (k + 0.3) / kDirections;
      keepFarthest({tilt * std::cos(angle), tilt * std::sin(angle), -1});
    }
  }
  return true;
}

template void IceContacts<float>::keepSupports(const IceBodies<float>&, std::vector<Contact>&);
template void IceContacts<double>::keepSupports(const IceBodies<double>&, std::vector<Contact>&);

}  // namespace ice_ice_baby
