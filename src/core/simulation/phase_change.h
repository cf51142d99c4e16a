// Everything that only scenes with heat or with floating solids have: the phases of particles and
// rigid bodies of ice and solids; with heat, temperatures of particles.
#pragma once

#include <optional>
#include <vector>

#include "base/stage_clock.h"
#include "colliders/colliders.h"
#include "ice/ice_bodies.h"
#include "ice/ice_contacts.h"
#include "ice/springs.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"
#include "phase/steam.h"
#include "thermal/thermal_solver.h"

namespace ice_ice_baby {

template <class Real>
class PhaseChange {
 public:
  /// @param scene, colliders, springs must outlive it; gravity is read from the scene in every
  /// substep
  /// @param springs springs of the simulator, which join ice while there is any
  PhaseChange(const Scene& scene, const std::vector<Spawn>& spawns,
              const Colliders<Real>& colliders, std::optional<Springs<Real>>& springs);
  PhaseChange(const PhaseChange&) = delete;
  PhaseChange& operator=(const PhaseChange&) = delete;

  /// Sets the initial phase and volume of every particle from its temperature.
  /// Makes the bodies of the solids.
  /// @param spawns of blocks and solids; ice of different spawns is not joined
  void begin(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
             const std::vector<Spawn>& spawns);

  // Within a substep, in this order.

  /// Updates volumes, and predicts x* of steam and of ice bodies.
  void predict(Particles<Real>& particles, double dt_s);
  /// Applies displacements of members as impulses on their bodies.
  void conform(VectorField<Real>& predicted);
  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);
  /// Call it after the neighbour lists were rebuilt.
  void followNeighbours(const Neighbours<Real>& neighbours);
  void findContacts(const VectorField<Real>& predicted, const Neighbours<Real>& neighbours);
  /// Applies displacements of members by water and other bodies as impulses on their bodies, and
  /// solves the contacts.
  void moveBodies(VectorField<Real>& predicted);
  /// Moves bodies back that would end the substep deep inside a collider.
  void contain(VectorField<Real>& predicted);
  void finish(Particles<Real>& particles);
  /// Applies changes of member velocities by viscosity as impulses on their bodies.
  void takeVelocities(Particles<Real>& particles);

  // Between two frames.

  /// Advances temperatures and phases. Heat conduction is slow, so one pass covers as many frames
  /// as possible, up to a visible delay. Phases change between frames, and not in every one.
  void advance(const Particles<Real>& particles, const Neighbours<Real>& neighbours, double air_c);
  /// Moves bodies along with colliders that jumped, and out of colliders that they overlap.
  void jump(const std::vector<Jump<Real>>& jumps, Particles<Real>& particles);
  /// Of floating solids, by their numbers in the scene. As IceBodies::grip and letGo.
  void grip(Index solid, const Posed& pose);
  void letGo(Index solid) { bodies_->letGo(bodies_->bodyOfSolid(solid)); }
  void wakeBodies();
  /// Takes all momenta off the bodies.
  void stopBodies();

  // Particles that come and go, between two frames.

  /// Appends particles of water, of one temperature. Call followParticles once they are sorted.
  void add(std::size_t count, double celsius);
  /// Solids go as a whole: clears the marks of those of which some particles stay.
  /// @param gone (n) whether a particle is about to be removed
  void keepWhole(std::vector<char>& gone) const;
  /// Removes particles from their bodies, which keep the momenta of the rest. The springs of these
  /// particles must have been removed before.
  /// @param gone (n) whether a particle is removed
  void release(const std::vector<char>& gone, const Particles<Real>& particles,
               const Neighbours<Real>& neighbours);
  /// Call it after particles were added or removed and the neighbour lists were rebuilt. Sets the
  /// phase of new particles.
  void followParticles(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// Whether ice is rigid, so that bodies instead of springs keep its shape.
  bool rigid() const { return heat_ && scene_.ice.compliance_m_n == 0.0; }
  const Phases<Real>& phases() const { return phases_; }
  /// Null without heat.
  ThermalSolver<Real>* heat() { return heat_ ? &*heat_ : nullptr; }
  const ThermalSolver<Real>* heat() const { return heat_ ? &*heat_ : nullptr; }
  /// Null while there are neither rigid ice nor solids.
  const IceBodies<Real>* bodies() const { return bodies_ ? &*bodies_ : nullptr; }
  /// Of those; null while there are none.
  const IceContacts<Real>* contacts() const { return contacts_ ? &*contacts_ : nullptr; }
  /// How often a body was slowed or moved back so far.
  std::uint64_t limited() const { return bodies_ ? bodies_->limited() + contacts_->limited() : 0; }

  /// Sets the numbers of the report that only these scenes have.
  void addTo(StepReport& report) const;
  StageStats contactsStage() const { return contacts_clock_.stats(contacts_->bytes()); }
  StageStats bodiesStage() const { return bodies_clock_.stats(bodies_->bytes()); }
  StageStats heatStage() const { return heat_clock_.stats(heat_->bytes()); }
  StageStats phasesStage() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive.optional(self.bodies_, self.scene_);
    archive.optional(self.contacts_, self.scene_);
    if (self.heat_) archive(*self.heat_);
    archive(self.phases_);
  }
  template <class Self, class Archive>
  static void exchangeTimes(Self& self, Archive& archive) {
    archive(self.heat_due_s_, self.phases_due_s_);
  }
  /// @throws InvalidInput if the state of a checkpoint does not match the particles
  void restore(const Particles<Real>& particles);

 private:
  void makeSolids(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                  const std::vector<Spawn>& spawns);
  void makeBodies();
  void labelBodies();
  void advanceHeat(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                   double air_c);
  void reportHeat(StepReport& report) const;
  void updatePhases(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                    double dt_s, const std::vector<Spawn>* apart = nullptr);
  void updateIce(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                 const std::vector<Spawn>* apart);
  void joinIce(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
               const std::vector<Spawn>* apart);
  void stickToColdWalls(const VectorField<Real>& position);
  void updateSteam();

  const Scene& scene_;
  const Colliders<Real>& colliders_;
  std::optional<Springs<Real>>& springs_;
  std::optional<ThermalSolver<Real>> heat_;  ///< if the scene is thermal
  Phases<Real> phases_;
  std::optional<IceBodies<Real>> bodies_;      ///< while there is rigid ice, or with solids
  std::optional<IceContacts<Real>> contacts_;  ///< of those
  std::optional<Steam<Real>> steam_;           ///< while there is steam
  std::vector<Index> body_labels_;             ///< (n) scratch of updateIce
  double heat_due_s_ = 0.0;                    ///< simulated time since the last thermal pass
  double phases_due_s_ = 0.0;                  ///< simulated time since the last update of phases
  StageClock contacts_clock_{"ice_contacts"};
  StageClock bodies_clock_{"ice_bodies"};
  StageClock heat_clock_{"heat"};
  StageClock phases_clock_{"phases"};
};

}  // namespace ice_ice_baby
