// State that was read from a checkpoint: refused where it makes no sense, and completed by what
// follows from it. Bytes may come from anywhere, so nothing is an index before it is held to its
// range here.
#include <algorithm>
#include <string>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/simulator.h"

namespace ice_ice_baby {

namespace {

void require(bool sense, const char* what) {
  if (!sense) throw InvalidInput(std::string("its state makes no sense: ") + what);
}

/// Whether every index is below `count` and none stands twice.
bool distinct(const std::vector<Index>& indices, std::size_t count) {
  std::vector<char> seen(count, false);
  return std::all_of(indices.begin(), indices.end(), [&](Index i) {
    const bool fresh = i < count && !seen[i];
    if (fresh) seen[i] = true;
    return fresh;
  });
}

bool belowOrNone(Index index, std::size_t count) { return index < count || index == kNone; }

template <class Real>
bool holds(const VectorField<Real>& field, std::size_t count) {
  return field.x.size() == count && field.y.size() == count && field.z.size() == count;
}

template <class Matrix>
bool isRotation(const Matrix& turn) {
  using Real = typename Matrix::Scalar;
  return turn.isUnitary(Real(1e-3)) && turn.determinant() > 0;
}

}  // namespace

template <class Real>
void Particles<Real>::settle(std::size_t count) {
  require(id.size() == count && distinct(id, count), "not every particle is there once");
  require(holds(position, count) && holds(velocity, count), "particles without a place");
  predicted = position;
}

template <class Real>
void DensityConstraint<Real>::settle(std::size_t particles) {
  const std::size_t started = warmStarts() ? particles : 0;
  require(density_.size() == particles && multiplier_.size() == particles &&
              holds(correction_, started),
          "densities of other particles");
  resize(particles);
}

template <class Real>
void Neighbours<Real>::settle(std::size_t particles) {
  if (particles == 0) return;
  require(holds(built_at_, particles + kPadding) && builds_ > 0, "lists of other particles");
  VectorField<Real> where = built_at_;
  where.resize(particles);
  const std::size_t builds = builds_;
  const std::vector<Index>& order = sortOrder(where);
  require(std::is_sorted(order.begin(), order.end()), "particles that are not sorted by cell");
  build(where);
  builds_ = builds;
}

template <class Real>
void Colliders<Real>::settle() const {
  const auto possible = [](const auto& pose) {
    return pose.position.cwiseAbs().maxCoeff() <= kMaxCoordinate_m && isRotation(pose.rotation);
  };
  const auto all = [&](const auto& bodies) {
    return std::all_of(bodies.begin(), bodies.end(), [&](const auto& body) {
      return possible(body.motion.from) && possible(body.motion.to);
    });
  };
  const bool travels = std::all_of(travels_.begin(), travels_.end(), [&](const Travel& travel) {
    return possible(travel.start) && possible(travel.target);
  });
  require(travels && all(containers) && all(planes) && all(spheres), "a collider that is nowhere");
}

template <class Real>
void Springs<Real>::settle(std::size_t particles) const {
  require(sheet_count_ <= springs_.size(), "sheets of more springs than there are");
  for (const Spring<Real>& spring : springs_) {
    require(spring.a < particles && spring.b < particles, "a spring that joins no particles");
  }
}

template <class Real>
void Heat<Real>::settle(std::size_t particles) const {
  require(enthalpy_.size() == particles && received_.size() == particles,
          "heat of other particles");
  require(regions_.size() <= kMaxHeatRegions, "too many heated regions");
}

template <class Real>
void Phases<Real>::settle(std::size_t particles, std::size_t colliders) {
  for (const std::size_t size : {phase_.size(), share_.size(), full_share_.size(), slush_.size(),
                                 wet_.size(), pressed_.size(), stuck_to_.size()}) {
    require(size == particles, "phases of other particles");
  }
  ice_count_ = steam_count_ = 0;
  for (std::size_t i = 0; i < particles; ++i) {
    require(phase_[i] <= Phase::kSteam, "a phase that does not exist");
    require(belowOrNone(stuck_to_[i], colliders), "ice that sticks to no collider");
    ice_count_ += phase_[i] == Phase::kIce;
    steam_count_ += phase_[i] == Phase::kSteam;
    steam_[i] = phase_[i] == Phase::kSteam;
    flows_[i] = phase_[i] == Phase::kWater || (elastic_ && phase_[i] == Phase::kIce);
  }
}

template <class Real>
void IceBodies<Real>::settle(std::size_t particles, std::size_t colliders) {
  const std::size_t members = place_.size();
  require(distinct(place_, particles) && offset_.size() == members && outward_.size() == members,
          "members of bodies that are no particles");
  body_of_.clear();
  for (const IceBody& body : bodies_) {
    const bool follows = body.first == body_of_.size() && body.first < body.surface_last &&
                         body.surface_last <= body.last && body.last <= members;
    require(follows && body.mass_kg > 0, "a body of no members");
    require(belowOrNone(body.anchor, colliders), "a body that no collider carries");
    require(belowOrNone(body.island, bodies_.size()), "a body beside none");
    body_of_.resize(body.last, static_cast<Index>(&body - bodies_.data()));
  }
  require(body_of_.size() == members, "members of no body");
  for (const Index member : renumbered_) {
    require(belowOrNone(member, members), "a member with a number that does not exist");
  }
  member_at_.assign(particles, kNone);
  for (Index m = 0; m < members; ++m) member_at_[place_[m]] = m;
  makeChunks();
}

template <class Real>
void IceContacts<Real>::settle(const IceBodies<Real>& bodies) const {
  // Contacts may be those of the members before the latest change: followMembers renumbers them.
  const bool follows = generation_ + 1 == bodies.generation();
  const bool known = follows || generation_ == bodies.generation();
  require(known, "contacts of bodies that are gone");
  const std::size_t members = follows ? bodies.renumbered().size() : bodies.members();
  const auto touches = [&](Index body, Index member) {
    return member < members && (follows || body == bodies.bodyOfMember(member));
  };
  for (const auto* contacts : {&walls_, &pairs_, &dormant_walls_, &dormant_pairs_}) {
    for (const Contact& contact : *contacts) {
      const bool alone = contact.b == kNone && contact.member_b == kNone;
      require(
          touches(contact.a, contact.member_a) && (alone || touches(contact.b, contact.member_b)),
          "a contact of no bodies");
    }
  }
  for (const Candidate& candidate : candidates_) {
    require(candidate.a < members && candidate.b < members, "members near to none");
  }
}

template <class Real>
void Simulator<Real>::settle() {
  const std::size_t n = particles_.size();
  std::size_t colliders = 0;
  forEachCollider(scene_, [&](const Collider&) { ++colliders; });
  std::size_t spawned = 0;
  for (const Spawn& spawn : spawns_) spawned += spawn.count;
  particles_.settle(spawned);
  density_->settle(n);
  colliders_.settle();
  require(substeps_ >= 1 && substeps_ <= 1000, "a number of substeps that cannot be");
  require(strictness_ >= 0.0 && strictness_ <= 1.0, "ice that is more than frozen");
  if (springs_) springs_->settle(n);
  if (heat_) {
    heat_->settle(n);
    phases_->settle(n, colliders);
    if (phases_->steamCount() > 0) steam_.emplace(scene_.steam);
    if (phases_->steamCount() == 0) steam_.reset();
  }
  require(bodies_.has_value() == contacts_.has_value() && (rigidIce() || !bodies_),
          "bodies of ice where there can be none");
  if (bodies_) {
    bodies_->settle(n, colliders);
    contacts_->settle(*bodies_);
  }
  temperature_.advanceTo(report_.time_s);
  arena_.execute([&] { neighbours_.settle(n); });
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
