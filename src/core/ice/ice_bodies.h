// Rigid bodies, of ice and floating solids: which particles belong to a body, and how a body moves.
// The members of a solid never change.
//
// A substep calls
//   predict -> IceContacts::find -> n x (conform, IceContacts::solve) -> IceContacts::contain ->
//   finish -> takeVelocities,
// with conform after every stage that moves single particles, and takeVelocities after every stage
// that changes their velocities. Position, predicted position and velocity of a member always
// follow from its body.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "colliders/colliders.h"
#include "ice/ice_body.h"
#include "ice_ice_baby/solid_state.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "solids/solid_mass.h"

namespace ice_ice_baby {

/// Largest rotation per substep, beyond which straight paths of members are meaningless.
constexpr double kMaxRotation_rad = 1.0;

template <class Real>
class IceBodies {
 public:
  explicit IceBodies(const Scene& scene);

  /// Makes one body of all particles with the same label. Call it between two substeps. A body
  /// whose members stay the same keeps all of its state. Any other body takes over the mass and
  /// momenta of its members, so linear and angular momentum are conserved and nothing moves. The
  /// rotation of a particle about its own centre (moment of inertia 2/5 m (d/10)^2, larger in small
  /// bodies) is lost when it melts, because water particles have none.
  /// @param neighbours lists valid at the present positions
  /// @param label (n) a number below n shared by the particles of a body; kNone: water
  /// @return whether anything changed; members are then renumbered and new bodies have no anchor
  bool assign(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
              const std::vector<Index>& label);

  /// Turns a body that assign has just made into a solid of the scene, with the mass, centre of
  /// mass and inertia of its shape, at its place and with its velocity. Call it between two
  /// substeps.
  /// @param solid its number in the scene
  /// @param point_m (n) by particle, in the frame of the solid
  void makeSolid(Index body, Index solid, const Solid& params, const std::vector<Vec3d>& point_m);

  /// Sets the labels of the particles of solids, for assign, so that these bodies stay.
  void labelSolids(std::vector<Index>& label) const;

  /// A solid goes as a whole: clears the marks of solids of which some particles stay.
  /// @param gone (n) whether a particle is about to be removed
  void keepWhole(std::vector<char>& gone) const;

  /// Body of a solid of the scene, or kNone if it has left the scene.
  Index bodyOfSolid(Index solid) const;
  /// Moves a solid to the pose of its frame within `time_s`, whatever touches it, and keeps it
  /// there.
  void grip(Index body, const Posed& pose, double time_s);
  /// Lets it go with the velocity that it has.
  void letGo(Index body) { bodies_[body].gripped = false; }

  /// Pose and motion of the frame of a solid. @param body that of a solid
  SolidState solidState(Index body) const;

  /// Follows a sort of the particles: place k now holds what was at order[k]. What is not in it is
  /// no member of a body.
  void reorder(const std::vector<Index>& order);

  /// Starts a substep: free flight, or the motion of the collider that the body is anchored to.
  void predict(Particles<Real>& particles, const Colliders<Real>& colliders,
               const Vec3d& gravity_m_s2, double dt_s);

  /// Applies displacements of single members as impulses on their bodies, and makes the bodies
  /// rigid again.
  void conform(VectorField<Real>& predicted);

  /// Moves members to the positions given by `next` of their bodies.
  /// @param all false: skip bodies that are asleep or anchored
  void writePredicted(VectorField<Real>& predicted, bool all = true) const;

  /// Ends the substep: sets poses, positions and velocities.
  void finish(Particles<Real>& particles);

  /// Applies changes of the velocities of single members since `finish` as impulses on their
  /// bodies.
  void takeVelocities(Particles<Real>& particles);

  /// Moves bodies along with containers that jump, and with any collider that they are anchored to,
  /// including their momenta. Call it between two substeps; `finish` then writes the members.
  void carry(const std::vector<Jump<Real>>& jumps, const Colliders<Real>& colliders);

  /// Anchors the body to a collider, which carries it from now on. No effect if already anchored.
  /// @param collider its number
  void anchor(Index body, Index collider, const Colliders<Real>& colliders);

  /// Puts dry, supported bodies to sleep that have been slower than `ice.sleep_speed_m_s` for half
  /// a second, and wakes wet bodies.
  /// @param wet (n) whether a particle touches water; empty: all are dry
  /// @param time_s time since the latest call
  void updateSleep(const std::vector<std::uint8_t>& wet, double time_s);
  void wakeAll();
  /// Takes all momenta off.
  void stopAll();
  /// Wakes a body after predict; it takes part in the present substep.
  void wakeInFlight(Index body);

  /// Calls visit(body) for every solid.
  template <class Visit>
  void forEachSolid(const Visit& visit) const {
    for (const IceBody& body : bodies_) {
      if (body.solid != kNone) visit(body);
    }
  }

  std::size_t count() const { return bodies_.size(); }
  /// Number of bodies that are solids.
  std::size_t solids() const;
  /// Number of bodies that sleep. @param solid whether to count solids, or ice
  std::size_t asleep(bool solid = false) const;
  const IceBody& body(Index b) const { return bodies_[b]; }
  IceBody& body(Index b) { return bodies_[b]; }
  /// Body of particle i, or kNone.
  Index bodyOf(Index i) const {
    const Index member = memberAt(i);
    return member == kNone ? kNone : body_of_[member];
  }

  std::size_t members() const { return place_.size(); }
  /// Member number of particle i, or kNone.
  Index memberAt(Index i) const { return i < member_at_.size() ? member_at_[i] : kNone; }
  Index placeOf(Index member) const { return place_[member]; }
  Index bodyOfMember(Index member) const { return body_of_[member]; }
  bool atSurface(Index member) const { return member < bodies_[body_of_[member]].surface_last; }
  /// Offset of a member from the centre of mass, in body axes, m.
  const Vec3d& offset(Index member) const { return offset_[member]; }
  /// Outward direction of a member in body axes. Its length grows with the exposed surface: about
  /// 0.36 on a flat face, 0.74 at a corner, 0 for a single particle.
  const Vec3d& outward(Index member) const { return outward_[member]; }

  /// Length of the present substep, s.
  double dt_s() const { return dt_s_; }
  double sleepSpeed_m_s() const { return sleep_speed_m_s_; }
  /// Number of calls of assign that changed something.
  std::size_t generation() const { return generation_; }
  /// (members before the latest change) present member number, or kNone if the body changed.
  /// Ascending: members whose bodies are kept keep their order.
  const std::vector<Index>& renumbered() const { return renumbered_; }

  /// How often a body was slowed to the speed limit or to a rotation of 1 rad per substep.
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
  /// The particles that share a label.
  struct Group {
    Index count;
    Index was;   ///< former body of its first particle
    bool kept;   ///< whether the former body has exactly these particles
    Index next;  ///< member number of its next particle
  };
  /// Members first ... last - 1 of one body; a sum over a chunk is one task.
  struct Chunk {
    Index body;
    Index first;
    Index last;
  };
  /// Sums over a chunk: of a quantity q, and of arm x q.
  struct Moment {
    Vec3d sum;
    Vec3d torque;
  };

  /// A group of awake bodies in contact with each other.
  struct Island {
    double still_s;  ///< shortest still time in the group
    bool supported;
  };

  double ownInertia(Index count) const;
  void restoreBody(const IceBody& body, const Particles<Real>& particles) const;
  SolidMass massOfMembers(const IceBody& body) const;
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
  Placement gripped(IceBody& body) const;
  void follow(IceBody& body, const Placement& to) const;
  void fly(IceBody& body);
  void limit(IceBody& body);
  template <class Visit>
  void forEachChunk(const Visit& visit) const;
  template <class Difference>
  void sumMoments(const Difference& difference);

  std::vector<SolidMass> solids_;  ///< of the scene
  double particle_kg_;
  double radius_m_;  ///< of a particle
  double sleep_speed_m_s_;
  double max_speed_m_s_;
  Vec3d gravity_m_s2_ = Vec3d::Zero();
  double dt_s_ = 1.0;
  std::vector<IceBody> bodies_;
  std::vector<Index> place_;      ///< (members) index of the particle
  std::vector<Vec3d> offset_;     ///< (members) m
  std::vector<Vec3d> outward_;    ///< (members)
  std::vector<Index> body_of_;    ///< (members)
  std::vector<Index> member_at_;  ///< (n) member, or kNone
  std::vector<Chunk> chunks_;
  std::vector<Index> batches_;   ///< first chunk of each task, and the end
  std::vector<Island> islands_;  ///< (bodies) scratch of updateSleep
  std::vector<Moment> moments_;  ///< (chunks)
  std::size_t generation_ = 0;
  std::vector<Index> renumbered_;
  std::atomic<std::uint64_t> limited_{0};

  std::vector<Index> group_of_label_;  ///< (n) scratch of assign, like all below
  std::vector<Group> groups_;
  std::vector<char> stays_;  ///< (bodies)
  std::vector<IceBody> old_bodies_;
  std::vector<Index> old_place_, old_body_of_, old_member_at_;
  std::vector<Vec3d> old_offset_, old_outward_;
  std::vector<Vec3d> bare_;  ///< (n) outward directions of members of new bodies
  std::vector<char> at_surface_;
};

}  // namespace ice_ice_baby
