// The part of a frame outside the substeps of Algorithm 1.
#include <algorithm>
#include <cmath>

#include "simulation/collider_jumps.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Compressed water is relaxed with at most this many corrections, or until the largest density is
/// within this fraction of rest density.
constexpr int kMaxCorrections = 100;
constexpr double kDense = 0.05;
/// Water whose mean density error is larger is compressed. What less stores is little.
constexpr double kCompressed = 0.01;

/// Displacements below this, in spacings, need no relaxation.
constexpr double kPressed_d = 0.01;

}  // namespace

template <class Real>
void Simulator<Real>::updateTemperature(double time_s) {
  temperature_.advanceTo(time_s);
  const double before = strictness_;
  strictness_ = scene_.thermal.enabled ? 0.0 : temperature_.strictness();
  if (strictness_ != before) wake();
  if (!scene_.thermal.enabled && strictness_ < 1.0 && springs_) {
    springs_->melt();
    if (strictness_ == 0.0 && springs_->empty()) springs_.reset();
  }
  report_.temperature_c = temperature_.celsius();
  if (!scene_.thermal.enabled) report_.strictness = strictness_;
  report_.springs = springs_ ? springs_->size() : 0;
}

template <class Real>
void Simulator<Real>::joinSheets() {
  for (std::size_t k = 0; k < scene_.blocks.size(); ++k) {
    if (!scene_.blocks[k].sheet) continue;
    if (!springs_) springs_.emplace(scene_.springs);
    springs_->addSheet(particles_, neighbours_, spawns_[k],
                       static_cast<Real>(1.5 * scene_.fluid.spacing_m));
  }
}

/// Frozen water that has been slower than the sleep speed for half a second sleeps; any change
/// wakes it. It does not sleep while a source is on.
template <class Real>
void Simulator<Real>::updateSleep() {
  const bool slow = report_.max_speed_m_s < scene_.springs.sleep_speed_m_s;
  still_s_ =
      springs_ && springs_->kept() && slow ? still_s_ + 1.0 / scene_.solver.frame_rate_hz : 0.0;
  if (report_.asleep || still_s_ < 0.5 || anyOpen(scene_.sources)) return;
  report_.asleep = true;
  for (auto* axis : {&particles_.velocity.x, &particles_.velocity.y, &particles_.velocity.z}) {
    std::fill(axis->begin(), axis->end(), Real(0));
  }
  if (phase_change_) phase_change_->stopBodies();
  updateReport();
}

template <class Real>
void Simulator<Real>::chooseSubsteps(double frame_wall_s) {
  if (!scene_.adaptsSubsteps() || report_.asleep) return;
  substep_control_.measure(scene_, frame_wall_s);
  if (springsCorrect()) return;
  const int before = substep_control_.substeps();
  substep_control_.follow(scene_, report_);
  if (substep_control_.substeps() > before && report_.density_error_mean > kCompressed) {
    substep_control_.limit(scene_, report_, relax(before, substep_control_.substeps()));
  }
  const int next = substep_control_.substeps();
  if (next != before) fluid_->rescale(double(before) / next);
}

/// Water that is compressed when it gets more substeps pushes back harder than it was pushed, as
/// its stiffness goes with the square of their number. So it is relaxed first, as far as it becomes
/// stiffer, with no more corrections than a frame takes.
/// @returns number of substeps, from `before` to `next`, for which it is relaxed
template <class Real>
int Simulator<Real>::relax(int before, int next) {
  const double compressed = report_.density_error_mean;
  const double ratio = double(before) / next;
  double error = compressed;
  const bool moved = correctPositions(next * scene_.solver.iterations, [&] {
    error = fluid_->densityError().mean;
    return error <= ratio * ratio * compressed;
  });
  if (moved) forgetCorrections();
  if (error <= ratio * ratio * compressed) return next;
  return std::max(before, static_cast<int>(before * std::sqrt(compressed / error)));
}

template <class Real>
void Simulator<Real>::jumpColliders() {
  const std::vector<Jump<Real>> jumps = jumpFastColliders(colliders_, particles_, farthest_m());
  if (!jumps.empty()) report_.speed_limited += carryAlong(jumps);
}

/// Moves the contents of colliders that jumped along, and water out of the way of them.
/// @returns number of particles carried
template <class Real>
std::size_t Simulator<Real>::carryAlong(const std::vector<Jump<Real>>& jumps) {
  const std::size_t carried = carry(jumps, colliders_, bodies(), particles_);
  if (phase_change_) phase_change_->jump(jumps, particles_);
  forgetCorrections();
  expelWater();
  return carried;
}

template <class Real>
void Simulator<Real>::expelWater() {
  const double farthest_m = expel(colliders_, bodies(), particles_);
  if (farthest_m > kPressed_d * scene_.fluid.spacing_m) makeRoom();
}

/// Corrects density as in the iterations of a substep, but without changing velocities, until
/// enough() or at most `max` times. @returns whether anything has moved
template <class Real>
template <class Enough>
bool Simulator<Real>::correctPositions(int max, const Enough& enough) {
  for (int k = 0; k < max; ++k) {
    findNeighbours();
    fluid_->updateDensity(particles_, neighbours_);
    if (enough()) return k > 0;
    fluid_->updateCorrections(particles_, neighbours_);
    respondToCollisions();
    updatePredicted();
    if (bodies()) bodies()->writePredicted(particles_.predicted);
    particles_.position = particles_.predicted;
  }
  return max > 0;
}

/// The next substep starts from what the water is now.
template <class Real>
void Simulator<Real>::forgetCorrections() {
  fluid_->forget();
  if (wrench_meter_) wrench_meter_->forget();
}

template <class Real>
void Simulator<Real>::makeRoom() {
  correctPositions(kMaxCorrections,
                   [&] { return static_cast<Real>(fluid_->maxDensity()) < Real(1 + kDense); });
  forgetCorrections();
}

template <class Real>
void Simulator<Real>::wake() {
  report_.asleep = false;
  still_s_ = 0.0;
  if (phase_change_) phase_change_->wakeBodies();
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
