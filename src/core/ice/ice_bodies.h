// Rigid bodies of ice: which particles move as one, and how.
//
// A substep calls
//   predict -> IceContacts::find -> n x (conform, IceContacts::solve) -> IceContacts::contain ->
//   finish -> takeVelocities,
// conform after whatever moved single particles and takeVelocities after whatever changed their
// velocities. Position, predicted position and velocity of a member always follow its body.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "colliders/colliders.h"
#include "ice/ice_body.h"
#include "particles/neighbours.h"
#include "particles/particles.h"

namespace ice_ice_baby {

template <class Real>
class IceBodies {
 public:
  explicit IceBodies(const Scene& scene);

  /// Makes particles of one label one body, between two substeps. A body whose members stay the
  /// same keeps all of its state; any other takes over mass and momenta of its members, so that
  /// linear and angular momentum are conserved and nothing moves. Only the spin of a particle about
  /// its own centre (2/5 m (d/10)^2 of inertia each, in small bodies more) is lost when it melts,
  /// as water has none.
  /// @param neighbours lists that hold at the present positions
  /// @param label (n) any number below n that the particles of a body share; kNone: water
  /// @return whether anything changed; members then have new numbers and new bodies no anchor
  bool assign(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
              const std::vector<Index>& label);

  /// Follows a sort of the particles: place k now holds what was at order[k]. What is not in it is
  /// no member of a body.
  void reorder(const std::vector<Index>& order);

  /// Begins a substep: free flight, or the motion of the collider a body is anchored to.
  void predict(Particles<Real>& particles, const Colliders<Real>& colliders,
               const Vec3d& gravity_m_s2, double dt_s);

  /// Takes what moved single members as impulses on their bodies, and makes them rigid again.
  void conform(VectorField<Real>& predicted);

  /// Puts members where their bodies' `next` has them. @param all false: but for held bodies
  void writePredicted(VectorField<Real>& predicted, bool all = true) const;

  /// Ends the substep: poses, positions and velocities are those of its end.
  void finish(Particles<Real>& particles);

  /// Takes what changed the velocities of single members after finish as impulses on their bodies.
  void takeVelocities(Particles<Real>& particles);

  /// Between two substeps takes along, with their momenta, the bodies in containers that jump and
  /// those anchored to anything that does. finish then writes their members.
  void carry(const std::vector<Jump<Real>>& jumps, const Colliders<Real>& colliders);

  /// From now on a collider carries the body. Nothing happens when it does already.
  /// @param collider its number
  void anchor(Index body, Index collider, const Colliders<Real>& colliders);

  /// Puts dry and supported bodies to sleep that have been slower than `ice.sleep_speed_m_s` for
  /// half a second, and wakes wet ones.
  /// @param wet (n) whether a particle touches water; empty: all are dry
  /// @param time_s since the latest call
  void updateSleep(const std::vector<std::uint8_t>& wet, double time_s);
  void wakeAll();
  /// Wakes a body after predict: it flies this substep like any other.
  void wakeInFlight(Index body);

  std::size_t count() const { return bodies_.size(); }
  std::size_t asleep() const;
  const IceBody& body(Index b) const { return bodies_[b]; }
  IceBody& body(Index b) { return bodies_[b]; }
  /// Body of the particle at place i, or kNone.
  Index bodyOf(Index i) const {
    const Index member = memberAt(i);
    return member == kNone ? kNone : body_of_[member];
  }

  std::size_t members() const { return place_.size(); }
  /// Member at place i, or kNone.
  Index memberAt(Index i) const { return i < member_at_.size() ? member_at_[i] : kNone; }
  Index placeOf(Index member) const { return place_[member]; }
  Index bodyOfMember(Index member) const { return body_of_[member]; }
  bool atSurface(Index member) const { return member < bodies_[body_of_[member]].surface_last; }
  /// From the centre of the body, in its axes, m.
  const Vec3d& offset(Index member) const { return offset_[member]; }
  /// Away from the other members near it, in the axes of the body; longer the more of the member
  /// lies bare: about 0.36 on a flat face, 0.74 at a corner, 0 for a single particle.
  const Vec3d& outward(Index member) const { return outward_[member]; }

  /// Length of the present substep, s.
  double dt_s() const { return dt_s_; }
  double sleepSpeed_m_s() const { return sleep_speed_m_s_; }
  /// Grows by one with every assign that changed something.
  std::size_t generation() const { return generation_; }
  /// (members before the latest change) their number since, or kNone where their body changed.
  /// Rises: members that keep their bodies keep their order.
  const std::vector<Index>& renumbered() const { return renumbered_; }

  /// Times that a body was slowed to the speed limit or to a turn of 1 rad in a substep.
  std::uint64_t limited() const { return limited_; }
  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.bodies_, self.place_, self.offset_, self.outward_, self.generation_,
            self.renumbered_);
  }
  /// Works out which member is where. @throws InvalidInput when what was read are no bodies of
  /// these particles, where they are, or one is anchored to none of the colliders
  void restore(const Particles<Real>& particles, const Colliders<Real>& colliders);

 private:
  /// Particles of one label.
  struct Group {
    Index count;
    Index was;   ///< body that its first particle was in
    bool kept;   ///< whether that body is just these
    Index next;  ///< member that its next particle becomes
  };
  /// Members first ... last - 1 of one body, few enough that a sum over them is one task.
  struct Chunk {
    Index body;
    Index first;
    Index last;
  };
  /// Sums over a chunk, of one kind of quantity: sum of m, and of arm x m.
  struct Moment {
    Vec3d sum;
    Vec3d turn;
  };

  /// Awake bodies that press on each other.
  struct Island {
    double still_s;  ///< of the least still of them
    bool supported;
  };

  double ownInertia(Index count) const;
  void restoreBody(const IceBody& body, const Particles<Real>& particles) const;
  bool isWet(const IceBody& body, const std::vector<std::uint8_t>& wet) const;
  bool gatherGroups(const std::vector<Index>& label);
  void putAside();
  void keepBodies();
  void makeBodies(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                  const std::vector<Index>& label);
  void makeBody(const Particles<Real>& particles, Index first, Index last);
  bool lookAround(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                  const std::vector<Index>& label, Index i);
  Index sortSurface(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                    const std::vector<Index>& label, Index first, Index last);
  void wakeBeside(const Neighbours<Real>& neighbours, const std::vector<Index>& label);
  void makeChunks();

  Placement held(const IceBody& body, const Colliders<Real>& colliders) const;
  void follow(IceBody& body, const Colliders<Real>& colliders) const;
  void fly(IceBody& body);
  void limit(IceBody& body);
  template <class Visit>
  void forEachChunk(const Visit& visit) const;
  template <class Difference>
  void sumMoments(const Difference& difference);

  double particle_kg_;
  double radius_m_;  ///< of a particle
  double sleep_speed_m_s_;
  double max_speed_m_s_;
  Vec3d gravity_m_s2_ = Vec3d::Zero();
  double dt_s_ = 1.0;
  std::vector<IceBody> bodies_;
  std::vector<Index> place_;      ///< (members) where the particle is
  std::vector<Vec3d> offset_;     ///< (members) m
  std::vector<Vec3d> outward_;    ///< (members)
  std::vector<Index> body_of_;    ///< (members)
  std::vector<Index> member_at_;  ///< (n) member, or kNone
  std::vector<Chunk> chunks_;
  std::vector<Index> batches_;   ///< first chunk of each task, and one end mark
  std::vector<Island> islands_;  ///< (bodies) scratch of updateSleep
  std::vector<Moment> moments_;  ///< (chunks)
  std::size_t generation_ = 0;
  std::vector<Index> renumbered_;
  std::atomic<std::uint64_t> limited_{0};

  std::vector<Index> group_of_label_;  ///< (n) scratch of assign, as all below
  std::vector<Group> groups_;
  std::vector<char> stays_;  ///< (bodies)
  std::vector<IceBody> old_bodies_;
  std::vector<Index> old_place_, old_body_of_, old_member_at_;
  std::vector<Vec3d> old_offset_, old_outward_;
  std::vector<Vec3d> bare_;  ///< (n) outward of members of new bodies
  std::vector<char> at_surface_;
};

}  // namespace ice_ice_baby
