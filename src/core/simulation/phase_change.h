// What heat changes: temperatures, which particles are water, ice and steam, and the rigid bodies
// that the ice makes. Only a scene with heat has it.
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
  /// @param scene, colliders, springs must outlive it; gravity is read from the scene as it is
  /// @param springs of the simulator: while there is ice, those that join it
  PhaseChange(const Scene& scene, const std::vector<Spawn>& spawns,
              const Colliders<Real>& colliders, std::optional<Springs<Real>>& springs);
  PhaseChange(const PhaseChange&) = delete;
  PhaseChange& operator=(const PhaseChange&) = delete;

  /// At the start everything has the phase and the volume of its temperature.
  /// @param spawns ice of one is not joined to that of another
  void begin(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
             const std::vector<Spawn>& spawns);

  // Within a substep, in this order.

  /// Lets volumes follow, steam rise and bodies fly: x* of both.
  void predict(Particles<Real>& particles, double dt_s);
  /// Takes what moved members of bodies since as impulses on all of their body.
  void conform(VectorField<Real>& predicted);
  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);
  /// To be called when the lists of neighbours are new.
  void followNeighbours(const Neighbours<Real>& neighbours);
  void findContacts(const VectorField<Real>& predicted, const Neighbours<Real>& neighbours);
  /// Takes what water and other bodies did to the members of a body as impulses on all of it.
  void moveBodies(VectorField<Real>& predicted);
  /// No body ends the substep deep inside a collider.
  void contain(VectorField<Real>& predicted);
  void finish(Particles<Real>& particles);
  /// Takes what viscosity did to the members of a body as impulses on all of it.
  void takeVelocities(Particles<Real>& particles);

  // Between two frames.

  /// Heat flows at its own, slow rate: a pass covers as many frames as it may, but no more than a
  /// person would notice. What it freezes, melts or boils changes between two frames, and not in
  /// every one.
  void advance(const Particles<Real>& particles, const Neighbours<Real>& neighbours, double air_c);
  /// Takes bodies along with colliders that jump, and puts those that lie in one beside it.
  void jump(const std::vector<Jump<Real>>& jumps, Particles<Real>& particles);
  void wakeBodies();

  // Particles that come and go, between two frames.

  /// Appends particles of one temperature; followParticles has to be called once they have places.
  void add(std::size_t count, double celsius);
  /// Takes particles that are about to go out of their bodies, which keep the momenta of the rest.
  /// Their springs are gone already.
  /// @param gone (n) whether a particle goes
  void release(const std::vector<char>& gone, const Particles<Real>& particles,
               const Neighbours<Real>& neighbours);
  /// To be called once particles came or went and neighbours are known: what came gets its phase.
  void followParticles(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// Whether ice is rigid: bodies, not springs, then keep its shape.
  bool rigid() const { return scene_.ice.compliance_m_n == 0.0; }
  const Phases<Real>& phases() const { return phases_; }
  ThermalSolver<Real>& heat() { return heat_; }
  const ThermalSolver<Real>& heat() const { return heat_; }
  /// Null while there is no rigid ice.
  const IceBodies<Real>* bodies() const { return bodies_ ? &*bodies_ : nullptr; }
  /// Times that a body was slowed or put back so far.
  std::uint64_t limited() const { return bodies_ ? bodies_->limited() + contacts_->limited() : 0; }

  /// Fills in what only a scene with heat has.
  void addTo(StepReport& report) const;
  StageStats contactsStage() const { return contacts_clock_.stats(contacts_->bytes()); }
  StageStats bodiesStage() const { return bodies_clock_.stats(bodies_->bytes()); }
  StageStats heatStage() const { return heat_clock_.stats(heat_.bytes()); }
  StageStats phasesStage() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive.optional(self.bodies_, self.scene_);
    archive.optional(self.contacts_, self.scene_);
    archive(self.heat_, self.phases_);
  }
  template <class Self, class Archive>
  static void exchangeTimes(Self& self, Archive& archive) {
    archive(self.heat_due_s_, self.phases_due_s_);
  }
  /// @throws InvalidInput when what was read does not belong to these particles
  void restore(const Particles<Real>& particles);

 private:
  void updatePhases(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                    double dt_s, const std::vector<Spawn>* apart = nullptr);
  void updateIce(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                 const std::vector<Spawn>* apart);
  void stickToColdWalls(const VectorField<Real>& position);
  void updateSteam();

  const Scene& scene_;
  const Colliders<Real>& colliders_;
  std::optional<Springs<Real>>& springs_;
  ThermalSolver<Real> heat_;
  Phases<Real> phases_;
  std::optional<IceBodies<Real>> bodies_;      ///< while there is rigid ice
  std::optional<IceContacts<Real>> contacts_;  ///< of those
  std::optional<Steam<Real>> steam_;           ///< while there is steam
  std::vector<Index> body_labels_;             ///< (n) scratch of updateIce
  double heat_due_s_ = 0.0;                    ///< simulated time that heat has yet to follow
  double phases_due_s_ = 0.0;                  ///< since phases last followed heat
  StageClock contacts_clock_{"ice_contacts"};
  StageClock bodies_clock_{"ice_bodies"};
  StageClock heat_clock_{"heat"};
  StageClock phases_clock_{"phases"};
};

}  // namespace ice_ice_baby
