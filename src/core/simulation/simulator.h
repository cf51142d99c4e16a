// The simulation loop: Algorithm 1 of the paper for one scene, in float or double.
#pragma once

#include <tbb/task_arena.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/archive.h"
#include "base/stage_clock.h"
#include "colliders/colliders.h"
#include "flow/drains.h"
#include "flow/sources.h"
#include "fluid/fluid.h"
#include "ice/springs.h"
#include "ice/temperature.h"
#include "ice_ice_baby/simulation.h"
#include "measure/vessel_tracker.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "simulation/phase_change.h"
#include "simulation/substep_control.h"
#include "wrenches/wrench_meter.h"

namespace ice_ice_baby {

/// Stages that a scene does not need do not exist: no springs while liquid, no collisions without
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
  void setHeatRegion(const std::string& name, bool active, double power_w) override;
  void moveHeatRegion(const std::string& name, const Posed& pose) override;
  Posed heatRegionPose(const std::string& name) const override;
  void setSource(const std::string& name, bool open, double flow_l_min) override;
  void moveSource(const std::string& name, const Posed& pose) override;
  void placeSource(const std::string& name, const Posed& pose) override;
  Posed sourcePose(const std::string& name) const override;
  void setGravity(const Vec3d& gravity_m_s2) override;
  void moveCollider(const std::string& name, const Posed& pose) override;
  void placeColliders(const std::vector<ColliderPlacement>& placements) override;
  Posed colliderPose(const std::string& name) const override { return colliders_.pose(name); }
  std::vector<SolidState> solids() const override;
  Posed solidPose(const std::string& name) const override;
  void holdSolid(const std::string& name, const Posed& pose) override;
  void releaseSolid(const std::string& name) override;
  void measureWrenches(bool measure) override;
  std::vector<ColliderWrench> wrenches() const override;
  void sample(std::vector<ParticleSample>& out, std::size_t stride) const override;
  void sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const override;
  void sampleRelativeVolumes(std::vector<float>& out) const override;
  void countFlows(bool on) override;
  std::vector<VesselReport> vessels() const override;
  std::vector<StageStats> stages() const override;
  std::uint64_t stateHash() const override;
  Precision precision() const override;
  void write(StateWriter& writer) const override;

  /// Adds particles between two frames, for example from a tap. The report contains the new number
  /// of particles at once; the rest of it changes after the next frame.
  /// @param position_m (k) within the bounds of the scene, outside colliders and at least a spacing
  /// from other particles
  /// @param velocity_m_s (k)
  /// @param celsius their temperature; ignored unless the scene is thermal
  /// @return id of the first; the others have consecutive ids
  /// @throws InvalidInput for vectors of different lengths, values out of range, and more particles
  /// than limits.max_particles; nothing has changed then
  std::uint32_t addParticles(const std::vector<Vec3d>& position_m,
                             const std::vector<Vec3d>& velocity_m_s, double celsius);

  /// Removes particles between two frames, for example through a drain, with their springs and
  /// their part in ice bodies.
  /// @param goes whether to remove the particle with this id at this position, m
  /// @return number of particles removed
  std::size_t removeParticles(
      const std::function<bool(std::uint32_t id, const Vec3d& position_m)>& goes);

  /// Restores the state that another simulator of the same scene wrote after the scene and the
  /// numbers of particles. @throws InvalidInput for invalid state; this object is unusable then
  /// @param particles present number of particles
  /// @param came number of particles added after the spawn, including those removed since
  void read(StateReader& reader, std::uint32_t particles, std::uint32_t came);

  /// State, for tests and measurements. Sorted by cell, so indices change between substeps.
  const Particles<Real>& particles() const { return particles_; }
  Particles<Real>& particles() { return particles_; }
  Neighbours<Real>& neighbours() { return neighbours_; }
  /// Null unless the scene has heat or solids.
  const PhaseChange<Real>* phaseChange() const { return phase_change_ ? &*phase_change_ : nullptr; }

 private:
  void runSubsteps();
  void judgeQuality();
  void substep(double dt_s);
  void endWrenches(double dt_s);
  void predict(double dt_s);
  void applyForcesAndPredict(Real dt);
  void projectCoarse(double dt_s);
  void findNeighbours();
  void renewNeighbours();
  void reorder(const std::vector<Index>& order);
  void separateCoincident();
  void removeSpilled();
  std::size_t remove(std::vector<char> gone);
  double room() const;
  void pour(int substep, int substeps);
  void drain();
  void pourFrom(std::size_t k, const std::vector<Drop>& drops);
  void pushAlong(Index i, const Vec3d& velocity_m_s);
  bool fluidAt(Index i) const;
  void settleNew(std::uint32_t first_id);
  void followParticles();
  void makeSprings();
  void correctSprings(double dt_s, int iteration);
  void respondToCollisions();
  template <class Answer>
  void respond(const VectorField<Real>* by, const Answer& answer);
  void updatePredicted();
  void finishCollisions();
  void updateVelocityAndPosition(Real dt);
  void requirePlacement(const std::string& name, const Posed& pose) const;
  Index requireSolid(const std::string& name) const;
  void requirePlacements(const std::vector<ColliderPlacement>& placements) const;
  /// What moves farther in a frame jumps, m.
  double farthest_m() const { return scene_.solver.max_speed_m_s / scene_.solver.frame_rate_hz; }
  void jumpColliders();
  std::size_t carryAlong(const std::vector<Jump<Real>>& jumps);
  void expelWater();
  void forgetCorrections();
  void makeRoom();
  int relax(int before, int next);
  template <class Enough>
  bool correctPositions(int max, const Enough& enough);
  void applyViscosity(double dt_s);
  void updateTemperature(double time_s);
  void updateReport();
  void observeVessels();
  std::vector<VesselContent> vesselContents(const MeasuredVessels& vessels) const;
  void addFlows(std::size_t vessel, double particle_m3, VesselReport& report) const;
  double elasticEnergy_j() const;
  void chooseSubsteps(double frame_wall_s);
  void updateSleep();
  void wake();
  void joinSheets();
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive);
  void writeState(StateWriter& writer) const;
  void restore(std::size_t particles);
  /// Number of particles that the scene spawned; these have the lowest ids.
  std::uint32_t spawned() const {
    return spawns_.empty() ? 0 : spawns_.back().first_id + spawns_.back().count;
  }
  /// Ids of the particles of floating solids.
  Spawn solidIds() const {
    if (scene_.solids.empty()) return {};
    const std::uint32_t first = spawns_[scene_.blocks.size()].first_id;
    return {first, spawned() - first};
  }
  bool frozen() const { return strictness_ >= 1.0; }
  const IceBodies<Real>* bodies() const {
    return phase_change_ ? phase_change_->bodies() : nullptr;
  }
  /// Null unless the scene is thermal.
  const ThermalSolver<Real>* heat() const {
    return phase_change_ ? phase_change_->heat() : nullptr;
  }
  const Phases<Real>* phases() const { return phase_change_ ? &phase_change_->phases() : nullptr; }
  /// Whether particle i belongs to a floating solid.
  bool solidAt(std::size_t i) const { return phase_change_ && phase_change_->phases().solid(i); }
  Phase phaseAt(std::size_t i) const;
  bool springsCorrect() const { return springs_ && !(phase_change_ && phase_change_->rigid()); }
  bool sticks() const { return frozen() && scene_.springs.stick_to_colliders; }

  Scene scene_;
  double mass_kg_;  ///< of a particle
  mutable tbb::task_arena arena_;
  std::vector<Spawn> spawns_;
  Particles<Real> particles_;
  Temperature temperature_;
  Colliders<Real> colliders_;
  Neighbours<Real> neighbours_;
  std::optional<Fluid<Real>> fluid_;  ///< always present; constructed after what it refers to
  std::optional<Springs<Real>> springs_;
  std::optional<PhaseChange<Real>> phase_change_;  ///< with heat or solids
  std::optional<WrenchMeter<Real>> wrench_meter_;  ///< while somebody asks for wrenches

  std::optional<VesselTracker<Real>> vessel_tracker_;  ///< while flows are counted

  std::optional<Sources> sources_;  ///< if the scene has any
  std::optional<Drains> drains_;    ///< if the scene has any

  std::vector<char> displaced_;  ///< (n) scratch of separateCoincident

  StageClock predict_clock_{"predict"};
  StageClock coarse_clock_{"coarse_level"};
  StageClock neighbours_clock_{"neighbours"};
  StageClock make_springs_clock_{"make_springs"};
  StageClock collide_clock_{"collide"};
  StageClock correct_springs_clock_{"correct_springs"};
  StageClock position_clock_{"position"};
  StageClock velocity_clock_{"velocity"};
  StageClock viscosity_clock_{"viscosity"};
  StageClock vessels_clock_{"vessels"};
  StageClock sources_clock_{"sources"};
  StageClock drains_clock_{"drains"};
  StageClock report_clock_{"report"};

  StepReport report_;
  SubstepControl substep_control_;
  double strictness_ = 0.0;
  double still_s_ = 0.0;  ///< how long frozen water has been below the sleep speed
  bool colliders_moving_ = false;
};

}  // namespace ice_ice_baby
