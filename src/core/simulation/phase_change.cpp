#include "simulation/phase_change.h"

#include <algorithm>
#include <limits>

#include "solids/solid_volumes.h"

namespace ice_ice_baby {

namespace {

/// Longest time between thermal passes, and shortest time between updates of phases, s simulated.
constexpr double kHeatWait_s = 0.1;
constexpr double kPhasesWait_s = 0.05;

}  // namespace

template <class Real>
PhaseChange<Real>::PhaseChange(const Scene& scene, const std::vector<Spawn>& spawns,
                               const Colliders<Real>& colliders,
                               std::optional<Springs<Real>>& springs)
    : scene_(scene),
      colliders_(colliders),
      springs_(springs),
      phases_(scene, spawns.empty() ? 0 : spawns.back().first_id + spawns.back().count) {
  const std::size_t blocks = scene.blocks.size();
  for (std::size_t k = blocks; k < spawns.size(); ++k) {
    phases_.makeSolid(spawns[k].first_id, solidVolumes(scene, scene.solids[k - blocks]));
  }
  if (!scene.thermal.enabled) return;
  heat_.emplace(scene, colliders);
  for (std::size_t k = 0; k < spawns.size(); ++k) {
    const bool water = k < blocks;
    heat_->add(spawns[k].count, water ? scene.blocks[k].celsius : scene.temperature.initial_c);
  }
}

template <class Real>
void PhaseChange<Real>::begin(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                              const std::vector<Spawn>& spawns) {
  if (!scene_.solids.empty()) makeSolids(particles, neighbours, spawns);
  if (heat_) phases_.update(heat_->curve(), heat_->enthalpy());
  phases_.swell(std::numeric_limits<double>::infinity());
  updatePhases(particles, neighbours, 0.0, &spawns);
}

template <class Real>
void PhaseChange<Real>::makeBodies() {
  if (bodies_) return;
  bodies_.emplace(scene_);
  contacts_.emplace(scene_);
}

/// Bodies are connected ice, and the solids.
template <class Real>
void PhaseChange<Real>::labelBodies() {
  if (rigid() && springs_) {
    springs_->labelBodies(phases_, body_labels_);
  } else {
    body_labels_.assign(phases_.size(), kNone);
  }
  if (bodies_) bodies_->labelSolids(body_labels_);
}

template <class Real>
void PhaseChange<Real>::predict(Particles<Real>& particles, double dt_s) {
  phases_.swell(dt_s);
  if (steam_) steam_->predict(particles, phases_, scene_.gravity_m_s2, dt_s);
  if (bodies_) bodies_->predict(particles, colliders_, scene_.gravity_m_s2, dt_s);
}

template <class Real>
void PhaseChange<Real>::conform(VectorField<Real>& predicted) {
  if (bodies_) bodies_->conform(predicted);
}

template <class Real>
void PhaseChange<Real>::reorder(const std::vector<Index>& order) {
  if (heat_) heat_->reorder(order);
  phases_.reorder(order);
  if (bodies_) bodies_->reorder(order);
}

template <class Real>
void PhaseChange<Real>::followNeighbours(const Neighbours<Real>& neighbours) {
  if (bodies_) phases_.findWet(neighbours);
}

template <class Real>
void PhaseChange<Real>::findContacts(const VectorField<Real>& predicted,
                                     const Neighbours<Real>& neighbours) {
  if (!bodies_) return;
  contacts_clock_.run([&] { contacts_->find(*bodies_, predicted, neighbours, colliders_); });
}

template <class Real>
void PhaseChange<Real>::moveBodies(VectorField<Real>& predicted) {
  if (!bodies_) return;
  bodies_clock_.run([&] {
    bodies_->conform(predicted);
    contacts_->solve(*bodies_, predicted);
  });
}

template <class Real>
void PhaseChange<Real>::contain(VectorField<Real>& predicted) {
  if (bodies_) bodies_clock_.run([&] { contacts_->contain(*bodies_, predicted); });
}

template <class Real>
void PhaseChange<Real>::finish(Particles<Real>& particles) {
  if (bodies_) bodies_clock_.run([&] { bodies_->finish(particles); });
}

template <class Real>
void PhaseChange<Real>::takeVelocities(Particles<Real>& particles) {
  if (bodies_) bodies_->takeVelocities(particles);
}

template <class Real>
void PhaseChange<Real>::advance(const Particles<Real>& particles,
                                const Neighbours<Real>& neighbours, double air_c) {
  if (heat_) advanceHeat(particles, neighbours, air_c);
  phases_due_s_ += 1.0 / scene_.solver.frame_rate_hz;
  if (phases_due_s_ < kPhasesWait_s) return;
  phases_clock_.run([&] { updatePhases(particles, neighbours, phases_due_s_); });
  phases_due_s_ = 0.0;
}

template <class Real>
void PhaseChange<Real>::advanceHeat(const Particles<Real>& particles,
                                    const Neighbours<Real>& neighbours, double air_c) {
  const double frame_s = 1.0 / scene_.solver.frame_rate_hz;
  heat_due_s_ += frame_s;
  SceneRegions* const regions = heat_->sceneRegions();
  if (regions) regions->addFrame(frame_s);
  const double pass_s = std::min(kHeatWait_s, heat_->passLength_s() / scene_.thermal.speedup);
  const bool wait = !regions || !regions->moved();
  if (wait && heat_due_s_ + frame_s <= pass_s) return;
  const ThermalStep<Real> step{heat_due_s_, air_c, &phases_.steamFlags(), &phases_.relativeVolume(),
                               scene_.solids.empty() ? nullptr : &phases_.all()};
  heat_clock_.run([&] { heat_->advance(particles, neighbours, step); });
  heat_due_s_ = 0.0;
}

template <class Real>
void PhaseChange<Real>::updatePhases(const Particles<Real>& particles,
                                     const Neighbours<Real>& neighbours, double dt_s,
                                     const std::vector<Spawn>* apart) {
  const bool changed = heat_ && phases_.update(heat_->curve(), heat_->enthalpy());
  if (changed) updateIce(particles, neighbours, apart);
  const IceParams& ice = scene_.ice;
  if (heat_ && springs_ && !rigid() && ice.break_strain > 0.0) {
    springs_->breakStretched(particles.position, ice.break_strain);
  }
  if (changed || bodies_) phases_.findWet(neighbours);
  updateSteam();
  if (bodies_) bodies_->updateSleep(phases_.wet(), dt_s);
}

template <class Real>
void PhaseChange<Real>::updateSteam() {
  if (phases_.steamCount() == 0) steam_.reset();
  if (phases_.steamCount() > 0 && !steam_) steam_.emplace(scene_.steam);
}

/// Joins new ice with springs and removes springs where ice melted.
template <class Real>
void PhaseChange<Real>::joinIce(const Particles<Real>& particles,
                                const Neighbours<Real>& neighbours,
                                const std::vector<Spawn>* apart) {
  if (phases_.iceCount() == 0) return springs_.reset();
  if (!springs_) springs_.emplace(scene_.springs);
  const double reach_m = scene_.springs.reach_h * scene_.supportRadius_m();
  springs_->breakMelted(phases_);
  springs_->freeze(particles, neighbours, phases_, static_cast<Real>(reach_m), apart);
}

/// Connected ice is a rigid body.
/// @param apart spawns that are not joined to each other; null: all ice is joined
template <class Real>
void PhaseChange<Real>::updateIce(const Particles<Real>& particles,
                                  const Neighbours<Real>& neighbours,
                                  const std::vector<Spawn>* apart) {
  joinIce(particles, neighbours, apart);
  if (phases_.iceCount() == 0 && scene_.solids.empty()) {
    bodies_.reset();
    contacts_.reset();
    return;
  }
  if (!rigid()) return;
  makeBodies();
  labelBodies();
  bodies_->assign(particles, neighbours, body_labels_);
  if (scene_.ice.stick_to_cold) stickToColdWalls(particles.position);
}

template <class Real>
void PhaseChange<Real>::stickToColdWalls(const VectorField<Real>& position) {
  for (Index i = 0; i < phases_.size(); ++i) {
    if (phases_.newIce(i)) {
      phases_.stick(i, heat_->wallColderThan(scene_.thermal.freezing_c, position.at(i)));
    }
    const Index wall = phases_.stuckTo(i);
    if (wall == kNone) continue;
    const Index body = bodies_->bodyOf(i);
    if (bodies_->body(body).anchor == kNone) bodies_->anchor(body, wall, colliders_);
  }
}

template <class Real>
void PhaseChange<Real>::jump(const std::vector<Jump<Real>>& jumps, Particles<Real>& particles) {
  if (!bodies_) return;
  bodies_->carry(jumps, colliders_);
  contacts_->expel(*bodies_, colliders_);
  bodies_->finish(particles);
}

template <class Real>
void PhaseChange<Real>::wakeBodies() {
  if (bodies_) bodies_->wakeAll();
}

template <class Real>
void PhaseChange<Real>::stopBodies() {
  if (bodies_) bodies_->stopAll();
}

template <class Real>
void PhaseChange<Real>::add(std::size_t count, double celsius) {
  if (!heat_) return phases_.add(count);
  heat_->add(count, celsius);
  phases_.add(heat_->curve(), heat_->enthalpy());
}

template <class Real>
void PhaseChange<Real>::release(const std::vector<char>& gone, const Particles<Real>& particles,
                                const Neighbours<Real>& neighbours) {
  if (!bodies_) return;
  contacts_->followMembers(*bodies_);
  labelBodies();
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) body_labels_[i] = kNone;
  }
  bodies_->assign(particles, neighbours, body_labels_);
  contacts_->followMembers(*bodies_);
}

template <class Real>
void PhaseChange<Real>::followParticles(const Particles<Real>& particles,
                                        const Neighbours<Real>& neighbours) {
  if (bodies_) contacts_->followMembers(*bodies_);
  if (heat_) {
    phases_.update(heat_->curve(), heat_->enthalpy());
    updateIce(particles, neighbours, nullptr);
  }
  phases_.findWet(neighbours);
  updateSteam();
}

template <class Real>
void PhaseChange<Real>::addTo(StepReport& report) const {
  const std::size_t solids = bodies_ ? bodies_->solids() : 0;
  report.ice_bodies = bodies_ ? bodies_->count() - solids : 0;
  report.ice_bodies_asleep = bodies_ ? bodies_->asleep() : 0;
  report.solids = solids;
  report.solids_asleep = bodies_ ? bodies_->asleep(true) : 0;
  report.ice_particles = phases_.iceCount();
  report.steam_particles = phases_.steamCount();
  if (heat_) reportHeat(report);
}

/// Solids have no heat.
template <class Real>
void PhaseChange<Real>::reportHeat(StepReport& report) const {
  std::size_t n = 0;
  double celsius = 0.0, ice = 0.0;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (phases_.solid(i)) continue;
    ++n;
    celsius += heat_->temperature(i);
    ice += heat_->iceFraction(i);
  }
  report.mean_celsius = n > 0 ? celsius / double(n) : 0.0;
  report.strictness = n > 0 ? ice / double(n) : 0.0;
  report.enthalpy_j = heat_->totalEnthalpy_j();
  report.thermal_speedup = heat_->reachedSpeedup();
}

template <class Real>
StageStats PhaseChange<Real>::phasesStage() const {
  return phases_clock_.stats(phases_.bytes() + (springs_ ? springs_->bytes() : 0));
}

template class PhaseChange<float>;
template class PhaseChange<double>;

}  // namespace ice_ice_baby
