// The simulation loop: Algorithm 1 of the paper over one scene, in float or double.
#pragma once

#include <tbb/task_arena.h>

#include <memory>
#include <optional>
#include <vector>

#include "base/archive.h"
#include "base/stage_clock.h"
#include "colliders/colliders.h"
#include "fluid/fluid.h"
#include "ice/ice_bodies.h"
#include "ice/ice_contacts.h"
#include "ice/springs.h"
#include "ice/temperature.h"
#include "ice_ice_baby/simulation.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"
#include "phase/steam.h"
#include "thermal/thermal_solver.h"

namespace ice_ice_baby {

/// A stage that a scene does not need is not there: no springs while liquid, no collisions without
/// colliders, no viscosity at rate zero.
template <class Real>
class Simulator final : public Simulation {
 public:
  Simulator(const Scene& scene, int threads);

  const StepReport& advanceFrame() override;
  const StepReport& report() const override { return report_; }
  const Scene& scene() const override { return scene_; }
  void setTemperature(double celsius, double ramp_s, const std::string& target) override;
  void heatRegion(const HeatedRegion& region) override;
  void setGravity(const Vec3d& gravity_m_s2) override;
  void moveCollider(const std::string& name, const Posed& pose) override;
  Posed colliderPose(const std::string& name) const override { return colliders_.pose(name); }
  void sample(std::vector<ParticleSample>& out, std::size_t stride) const override;
  void sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const override;
  DensityError measureDensityError() override;
  std::size_t countEscaped() const override;
  std::vector<StageStats> stages() const override;
  std::uint64_t stateHash() const override;
  Precision precision() const override;
  void write(StateWriter& writer) const override;

  /// Takes over what another simulator of the same scene wrote behind the scene and the number of
  /// particles. @throws InvalidInput when it makes no sense; this one is then of no more use
  void read(StateReader& reader);

  /// State for tests and measurement; sorted by cell, so indices change from substep to substep.
  const Particles<Real>& particles() const { return particles_; }
  Particles<Real>& particles() { return particles_; }
  Neighbours<Real>& neighbours() { return neighbours_; }

 private:
  void runSubsteps();
  void substep(double dt_s);
  void predict(double dt_s);
  void applyForcesAndPredict(Real dt);
  void predictSteamAndIce(double dt_s);
  void findNeighbours();
  void separateCoincident();
  void makeSprings();
  void correctSprings(double dt_s, int iteration);
  void respondToCollisions();
  void updatePredicted();
  void finishCollisions();
  void updateVelocityAndPosition(Real dt);
  void findContacts();
  void moveBodies();
  void jumpColliders();
  void carry(const std::vector<Jump<Real>>& jumps);
  void expel();
  void makeRoom();
  void applyViscosity(double dt_s);
  void updateTemperature(double time_s);
  void updateReport();
  double elasticEnergy_j() const;
  void followTargetError();
  void updateSleep();
  void wake();
  void joinSheets();
  void advanceHeat();
  void beginPhases();
  void updatePhases(double dt_s);
  void updateIce();
  void stickToColdWalls();
  void reportHeat();
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive);
  void writeState(StateWriter& writer) const;
  void settle();
  bool frozen() const { return strictness_ >= 1.0; }
  bool inBody(std::size_t i) const { return bodies_ && bodies_->memberAt(Index(i)) != kNone; }
  bool rigidIce() const { return heat_ && scene_.ice.compliance_m_n == 0.0; }
  bool springsCorrect() const { return springs_ && !rigidIce(); }
  bool sticks() const { return frozen() && scene_.springs.stick_to_colliders; }

  Scene scene_;
  double mass_kg_;  ///< of a particle
  tbb::task_arena arena_;
  std::vector<Spawn> spawns_;
  Particles<Real> particles_;
  Temperature temperature_;
  Colliders<Real> colliders_;
  Neighbours<Real> neighbours_;
  std::optional<Fluid<Real>> fluid_;  ///< always there, but made after what it refers to
  std::optional<Springs<Real>> springs_;
  std::optional<ThermalSolver<Real>> heat_;
  std::optional<Phases<Real>> phases_;         ///< with heat
  std::optional<IceBodies<Real>> bodies_;      ///< while there is rigid ice
  std::optional<IceContacts<Real>> contacts_;  ///< of those
  std::optional<Steam<Real>> steam_;           ///< while there is steam
  std::optional<BoundaryDensity<Real>>
      reference_boundary_;  ///< of measureDensityError, once it is asked

  std::vector<char> displaced_;     ///< (n) scratch of separateCoincident
  std::vector<Index> body_labels_;  ///< (n) scratch of updateIce

  StageClock predict_clock_{"predict"};
  StageClock neighbours_clock_{"neighbours"};
  StageClock make_springs_clock_{"make_springs"};
  StageClock contacts_clock_{"ice_contacts"};
  StageClock collide_clock_{"collide"};
  StageClock correct_springs_clock_{"correct_springs"};
  StageClock position_clock_{"position"};
  StageClock bodies_clock_{"ice_bodies"};
  StageClock velocity_clock_{"velocity"};
  StageClock viscosity_clock_{"viscosity"};
  StageClock heat_clock_{"heat"};
  StageClock phases_clock_{"phases"};
  StageClock report_clock_{"report"};

  StepReport report_;
  int substeps_;  ///< of the frame that comes next
  double strictness_ = 0.0;
  double heat_due_s_ = 0.0;    ///< simulated time that heat has yet to follow
  double phases_due_s_ = 0.0;  ///< since phases last followed heat
  double still_s_ = 0.0;       ///< for how long frozen water has been slower than the sleep speed
  bool colliders_moving_ = false;
};

}  // namespace ice_ice_baby
