// Decides which particles form an ice body, and what the body inherits when that changes.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "ice/ice_bodies.h"

namespace ice_ice_baby {

namespace {

/// Number of members summed by one task.
constexpr Index kChunk = 1024;

/// Bodies with at most this many particles may be a straight row.
constexpr Index kFew = 4;

}  // namespace

/// Moment of inertia of a particle about its own centre. Without it a row of particles could rotate
/// about its axis at no cost. In small bodies it is that of a sphere; in large ones it is small, so
/// that the angular momentum is that of the particles. A single particle has so much that it does
/// not roll.
template <class Real>
double IceBodies<Real>::ownInertia(Index count) const {
  const double share = count == 1 ? 1e6 : count <= kFew ? 1.0 : 0.04;
  return share * 0.4 * particle_kg_ * radius_m_ * radius_m_;
}

/// @return whether any body changes
template <class Real>
bool IceBodies<Real>::gatherGroups(const std::vector<Index>& label) {
  group_of_label_.assign(label.size(), kNone);
  groups_.clear();
  for (Index i = 0; i < label.size(); ++i) {
    if (label[i] == kNone) continue;
    Index& g = group_of_label_[label[i]];
    if (g == kNone) {
      g = static_cast<Index>(groups_.size());
      groups_.push_back({0, bodyOf(i), true, 0});
    }
    Group& group = groups_[g];
    ++group.count;
    group.kept = group.kept && bodyOf(i) == group.was;
  }
  bool same = groups_.size() == bodies_.size();
  for (Group& group : groups_) {
    group.kept = group.kept && group.was != kNone && group.count == bodies_[group.was].count();
    same = same && group.kept;
  }
  return !same;
}

/// Copies the unchanged bodies, in their order, from the old arrays.
template <class Real>
void IceBodies<Real>::keepBodies() {
  stays_.assign(old_bodies_.size(), 0);
  for (const Group& group : groups_) {
    if (group.kept) stays_[group.was] = 1;
  }
  for (Index b = 0; b < old_bodies_.size(); ++b) {
    if (!stays_[b]) continue;
    const IceBody& old = old_bodies_[b];
    IceBody body = old;
    body.island = kNone;
    body.first = static_cast<Index>(place_.size());
    body.last = body.first + static_cast<Index>(old.count());
    body.surface_last = body.first + (old.surface_last - old.first);
    for (Index m = old.first; m < old.last; ++m) {
      renumbered_[m] = static_cast<Index>(place_.size());
      place_.push_back(old_place_[m]);
      offset_.push_back(old_offset_[m]);
      outward_.push_back(old_outward_[m]);
      body_of_.push_back(static_cast<Index>(bodies_.size()));
    }
    bodies_.push_back(body);
  }
}

/// Combined state of the members first ... last - 1. Members that were in a body contribute its
/// exact pose and velocity rather than rounded ones, and their part of its rotation.
template <class Real>
void IceBodies<Real>::makeBody(const Particles<Real>& particles, Index first, Index last) {
  IceBody body;
  body.first = first;
  body.last = last;
  body.mass_particles = double(last - first);
  body.mass_kg = particle_kg_ * body.mass_particles;
  const auto oldBody = [&](Index m) -> const IceBody* {
    const Index was = old_member_at_.empty() ? kNone : old_member_at_[place_[m]];
    return was == kNone ? nullptr : &old_bodies_[old_body_of_[was]];
  };
  const auto velocity = [&](Index m, const IceBody* old) -> Vec3d {
    if (!old) return particles.velocity.at(place_[m]).template cast<double>();
    return old->velocity_m_s + old->angularVelocity().cross(offset_[m] - old->pose.centre_m);
  };
  Vec3d centre = Vec3d::Zero(), speed = Vec3d::Zero();
  for (Index m = first; m < last; ++m) {
    const IceBody* old = oldBody(m);
    offset_[m] = old ? old->pose.at(old_offset_[old_member_at_[place_[m]]])
                     : particles.position.at(place_[m]).template cast<double>().eval();
    centre += offset_[m];
    speed += velocity(m, old);
  }
  centre /= double(last - first);
  body.velocity_m_s = speed / double(last - first);
  const double own = ownInertia(last - first);
  for (Index m = first; m < last; ++m) {
    const IceBody* old = oldBody(m);
    const Vec3d arm = offset_[m] - centre;
    body.angular_momentum += particle_kg_ * arm.cross(velocity(m, old) - body.velocity_m_s);
    if (old) {
      const Index company = old->last - old->first;
      body.angular_momentum += ownInertia(company) * old->angularVelocity();
    }
    body.inertia +=
        particle_kg_ * (arm.squaredNorm() * Mat3<double>::Identity() - arm * arm.transpose());
    body.radius_m = std::max(body.radius_m, arm.norm());
  }
  for (Index m = first; m < last; ++m) offset_[m] -= centre;
  body.inertia += own * double(last - first) * Mat3<double>::Identity();
  body.mobility = body.inertia.inverse();
  body.pose = {centre, Eigen::Quaterniond::Identity()};
  body.moveTo(body.pose);
  body.speed_m_s = body.fastest_m_s();
  bodies_.push_back(body);
}

/// Wakes unchanged bodies beside particles that changed body, as their support may be gone.
template <class Real>
void IceBodies<Real>::wakeBeside(const Neighbours<Real>& neighbours,
                                 const std::vector<Index>& label) {
  const auto changed = [&](Index j) {
    const Index was = old_member_at_.empty() ? kNone : old_member_at_[j];
    if (label[j] == kNone) return was != kNone;
    return !(was != kNone && renumbered_[was] != kNone);
  };
  for (IceBody& body : bodies_) {
    if (!body.asleep) continue;
    for (Index m = body.first; m < body.surface_last && body.asleep; ++m) {
      const auto list = neighbours.of(place_[m]);
      if (std::none_of(list.begin(), list.end(), changed)) continue;
      body.asleep = false;
      body.still_s = 0.0;
    }
  }
}

template <class Real>
void IceBodies<Real>::makeChunks() {
  chunks_.clear();
  batches_.clear();
  Index batched = kChunk;
  for (Index b = 0; b < bodies_.size(); ++b) {
    for (Index first = bodies_[b].first; first < bodies_[b].last; first += kChunk) {
      if (batched >= kChunk) {
        batches_.push_back(static_cast<Index>(chunks_.size()));
        batched = 0;
      }
      chunks_.push_back({b, first, std::min(first + kChunk, bodies_[b].last)});
      batched += chunks_.back().last - first;
    }
  }
  batches_.push_back(static_cast<Index>(chunks_.size()));
}

/// Saves the present arrays while new ones are built from them.
template <class Real>
void IceBodies<Real>::putAside() {
  const auto aside = [](auto& values, auto& old) {
    old.swap(values);
    values.clear();
  };
  aside(bodies_, old_bodies_);
  aside(place_, old_place_);
  aside(offset_, old_offset_);
  aside(outward_, old_outward_);
  aside(body_of_, old_body_of_);
  aside(member_at_, old_member_at_);
  renumbered_.assign(old_place_.size(), kNone);
}

/// Creates bodies for the groups that are not kept, in the order of their first members.
template <class Real>
void IceBodies<Real>::makeBodies(const Particles<Real>& particles,
                                 const Neighbours<Real>& neighbours,
                                 const std::vector<Index>& label) {
  auto members = static_cast<Index>(place_.size());
  const Index first_new = members;
  for (Group& group : groups_) {
    if (group.kept) continue;
    group.next = members;
    members += group.count;
  }
  place_.resize(members);
  offset_.resize(members);
  outward_.resize(members);
  body_of_.resize(members);
  for (Index i = 0; i < label.size(); ++i) {
    if (label[i] == kNone) continue;
    Group& group = groups_[group_of_label_[label[i]]];
    if (!group.kept) place_[group.next++] = i;
  }
  for (Index first = first_new, last; first < members; first = last) {
    last = groups_[group_of_label_[label[place_[first]]]].next;
    const Index surface_last = sortSurface(particles.position, neighbours, label, first, last);
    makeBody(particles, first, last);
    bodies_.back().surface_last = surface_last;
    std::fill(body_of_.begin() + first, body_of_.begin() + last,
              static_cast<Index>(bodies_.size() - 1));
  }
}

template <class Real>
bool IceBodies<Real>::assign(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                             const std::vector<Index>& label) {
  if (!gatherGroups(label)) return false;
  ++generation_;
  putAside();
  keepBodies();
  makeBodies(particles, neighbours, label);
  member_at_.assign(label.size(), kNone);
  for (Index m = 0; m < place_.size(); ++m) member_at_[place_[m]] = m;
  wakeBeside(neighbours, label);
  makeChunks();
  return true;
}

template <class Real>
std::size_t IceBodies<Real>::bytes() const {
  const std::size_t vectors = offset_.capacity() + old_offset_.capacity() + outward_.capacity() +
                              old_outward_.capacity() + bare_.capacity();
  const std::size_t indices = place_.capacity() + body_of_.capacity() + member_at_.capacity() +
                              batches_.capacity() + renumbered_.capacity() +
                              group_of_label_.capacity() + old_place_.capacity() +
                              old_body_of_.capacity() + old_member_at_.capacity();
  return (bodies_.capacity() + old_bodies_.capacity()) * sizeof(IceBody) + vectors * sizeof(Vec3d) +
         indices * sizeof(Index) + chunks_.capacity() * sizeof(Chunk) +
         moments_.capacity() * sizeof(Moment) + groups_.capacity() * sizeof(Group) +
         solids_.capacity() * sizeof(SolidMass) + islands_.capacity() * sizeof(Island) +
         at_surface_.capacity() + stays_.capacity();
}

template class IceBodies<float>;
template class IceBodies<double>;

}  // namespace ice_ice_baby
