// What heat brings into the step: steam and rigid ice in a substep, heat, phases and their report
// once a frame.
#include <algorithm>
#include <limits>

#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Heat waits no longer than this, and changes of phase no shorter, s of simulated time.
constexpr double kHeatWait_s = 0.1;
constexpr double kPhasesWait_s = 0.05;

}  // namespace

/// Volumes change, steam rises, and members of a body fly with it.
template <class Real>
void Simulator<Real>::predictSteamAndIce(double dt_s) {
  phases_->swell(dt_s);
  if (steam_) steam_->predict(particles_, *phases_, scene_.gravity_m_s2, dt_s);
  if (bodies_) bodies_->predict(particles_, colliders_, scene_.gravity_m_s2, dt_s);
}

template <class Real>
void Simulator<Real>::findContacts() {
  contacts_->find(*bodies_, particles_.predicted, neighbours_, colliders_);
}

/// Takes what the water and other bodies did to the members of a body as impulses on all of it.
template <class Real>
void Simulator<Real>::moveBodies() {
  bodies_->conform(particles_.predicted);
  contacts_->solve(*bodies_, particles_.predicted);
}

/// Heat flows at its own, slow rate: a pass covers as many frames as it may, but no more than a
/// person would notice. What it freezes, melts or boils changes between two frames, and not in
/// every one.
template <class Real>
void Simulator<Real>::advanceHeat() {
  const double frame_s = 1.0 / scene_.solver.frame_rate_hz;
  heat_due_s_ += frame_s;
  const double pass_s = std::min(kHeatWait_s, heat_->passLength_s() / scene_.thermal.speedup);
  if (heat_due_s_ + frame_s > pass_s) {
    const ThermalStep<Real> step{heat_due_s_, temperature_.celsius(), &phases_->steamFlags(),
                                 &phases_->share()};
    heat_clock_.run([&] { heat_->advance(particles_, neighbours_, step); });
    heat_due_s_ = 0.0;
  }
  phases_due_s_ += frame_s;
  if (phases_due_s_ < kPhasesWait_s) return;
  phases_clock_.run([&] { updatePhases(phases_due_s_); });
  phases_due_s_ = 0.0;
}

/// At the start everything has the volume of what it is.
template <class Real>
void Simulator<Real>::beginPhases() {
  phases_->update(heat_->curve(), heat_->enthalpy());
  phases_->swell(std::numeric_limits<double>::infinity());
  updatePhases(0.0);
}

template <class Real>
void Simulator<Real>::updatePhases(double dt_s) {
  const bool changed = phases_->update(heat_->curve(), heat_->enthalpy());
  if (changed) updateIce();
  const IceParams& ice = scene_.ice;
  if (springsCorrect() && ice.break_strain > 0.0) {
    springs_->breakStretched(particles_.position, ice.break_strain);
  }
  if (changed || bodies_) phases_->findWet(neighbours_);
  if (phases_->steamCount() == 0) steam_.reset();
  if (phases_->steamCount() > 0 && !steam_) steam_.emplace(scene_.steam);
  if (bodies_) bodies_->updateSleep(phases_->wet(), dt_s);
}

/// Springs join what froze and break where it melted; what they join is one rigid body.
template <class Real>
void Simulator<Real>::updateIce() {
  if (phases_->iceCount() == 0) {
    springs_.reset();
    bodies_.reset();
    contacts_.reset();
    return;
  }
  if (!springs_) springs_.emplace(scene_.springs);
  const double reach_m = scene_.springs.reach_h * scene_.supportRadius_m();
  springs_->breakMelted(*phases_);
  const bool at_start = report_.frame == 0;  // blocks that begin as ice are bodies of their own
  springs_->freeze(particles_, neighbours_, *phases_, static_cast<Real>(reach_m),
                   at_start ? &spawns_ : nullptr);
  if (!rigidIce()) return;
  if (!bodies_) {
    bodies_.emplace(scene_);
    contacts_.emplace(scene_);
  }
  springs_->labelBodies(*phases_, body_labels_);
  bodies_->assign(particles_, neighbours_, body_labels_);
  if (scene_.ice.stick_to_cold) stickToColdWalls();
}

template <class Real>
void Simulator<Real>::stickToColdWalls() {
  for (Index i = 0; i < particles_.size(); ++i) {
    if (phases_->newIce(i)) {
      phases_->stick(i,
                     heat_->wallColderThan(scene_.thermal.freezing_c, particles_.position.at(i)));
    }
    const Index wall = phases_->stuckTo(i);
    if (wall == kNone) continue;
    const Index body = bodies_->bodyOf(i);
    if (bodies_->body(body).anchor == kNone) bodies_->anchor(body, wall, colliders_);
  }
}

template <class Real>
void Simulator<Real>::reportHeat() {
  const std::size_t n = particles_.size();
  double celsius = 0.0, ice = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    celsius += heat_->temperature(i);
    ice += heat_->iceFraction(i);
  }
  report_.mean_celsius = n > 0 ? celsius / double(n) : 0.0;
  report_.strictness = n > 0 ? ice / double(n) : 0.0;
  report_.enthalpy_j = heat_->totalEnthalpy_j();
  report_.thermal_speedup = heat_->reachedSpeedup();
  report_.ice_bodies = bodies_ ? bodies_->count() : 0;
  report_.ice_bodies_asleep = bodies_ ? bodies_->asleep() : 0;
  report_.ice_particles = phases_->iceCount();
  report_.steam_particles = phases_->steamCount();
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
