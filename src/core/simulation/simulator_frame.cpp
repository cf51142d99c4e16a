// The part of a frame outside the substeps of Algorithm 1.
#include <algorithm>
#include <cmath>

#include "simulation/collider_jumps.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Share of the promised error of a quality from which on it is followed, in the mean over the run
/// or, before that is over, over the first frames.
constexpr double kWatched = 0.6, kFirstFrames = 60.0;
/// In a substep water moves at most this far, in spacings: twice its root mean square speed.
constexpr double kMaxStep_d = 1.0;
/// The same for water under pressure, over the square root of the promised error: 0.2 at 0.2 %.
constexpr double kPressedStep_d = 4.47;

/// Compressed water is relaxed with at most this many corrections, or until the largest density is
/// within this fraction of rest density.
constexpr int kMaxCorrections = 100;
constexpr double kDense = 0.05;

/// Displacements below this, in spacings, need no relaxation.
constexpr double kPressed_d = 0.01;

}  // namespace

template <class Real>
void Simulator<Real>::updateTemperature(double time_s) {
  temperature_.advanceTo(time_s);
  const double before = strictness_;
  strictness_ = phase_change_ ? 0.0 : temperature_.strictness();
  if (strictness_ != before) wake();
  if (!phase_change_ && strictness_ < 1.0 && springs_) {
    springs_->melt();
    if (strictness_ == 0.0 && springs_->empty()) springs_.reset();
  }
  report_.temperature_c = temperature_.celsius();
  if (!phase_change_) report_.strictness = strictness_;
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
/// wakes it.
template <class Real>
void Simulator<Real>::updateSleep() {
  const bool slow = report_.max_speed_m_s < scene_.springs.sleep_speed_m_s;
  still_s_ =
      springs_ && springs_->kept() && slow ? still_s_ + 1.0 / scene_.solver.frame_rate_hz : 0.0;
  if (report_.asleep || still_s_ < 0.5) return;
  report_.asleep = true;
  for (auto* axis : {&particles_.velocity.x, &particles_.velocity.y, &particles_.velocity.z}) {
    std::fill(axis->begin(), axis->end(), Real(0));
  }
  updateReport();
}

/// Keeps the error, and the distance that water moves, below bounds. The error is proportional to
/// the square of the substep. More substeps make water stiffer, which adds energy if it is
/// compressed at that moment. So with a quality their number rises one by one with the speed of
/// water under pressure, before it is compressed, and follows the error only while that of the run
/// comes near the promise. It falls by one per frame at most, so that a calm frame does not leave
/// too few for the next one.
template <class Real>
void Simulator<Real>::followTargetError() {
  const double target = scene_.solver.target_error;
  if (target == 0.0 || report_.asleep || springsCorrect()) return;
  const double d_m = scene_.fluid.spacing_m, rate_1_s = scene_.solver.frame_rate_hz;
  const double for_error = substeps_ * std::sqrt(report_.density_error_mean / target);
  const double step_d = 2.0 * report_.rms_speed_m_s / (rate_1_s * d_m);
  const bool own_target = fewest_substeps_ == kMinSubsteps;
  const double frames = double(report_.frame);
  const double run_error = report_.density_error_run * frames / std::max(frames, kFirstFrames);
  double wanted = scene_.substepsForFall();
  if (own_target) {
    wanted = std::max({wanted, for_error, step_d / kMaxStep_d});
  } else {
    const double for_speed =
        std::min(step_d / (kPressedStep_d * std::sqrt(target)), for_error / std::sqrt(kWatched));
    wanted = std::max(wanted, std::min(for_speed, substeps_ + 1.0));
    if (run_error > kWatched * target) wanted = std::max(wanted, for_error);
  }
  const double fewest = std::max(fewest_substeps_, substeps_ - 1);
  const double max = std::min<double>(kMaxSubsteps, 2 * substeps_);
  const int next = static_cast<int>(std::clamp(std::ceil(wanted), std::min(fewest, max), max));
  if (next == substeps_) return;
  fluid_->rescale(double(substeps_) / next);
  substeps_ = next;
}

template <class Real>
void Simulator<Real>::jumpColliders() {
  const double max_m = scene_.solver.max_speed_m_s / scene_.solver.frame_rate_hz;
  const std::vector<Jump<Real>> jumps = jumpFastColliders(colliders_, particles_, max_m);
  if (jumps.empty()) return;
  report_.speed_limited += carry(jumps, colliders_, bodies(), particles_);
  if (phase_change_) phase_change_->jump(jumps, particles_);
  fluid_->forget();
  expelWater();
}

template <class Real>
void Simulator<Real>::expelWater() {
  const double farthest_m = expel(colliders_, bodies(), particles_);
  if (farthest_m > kPressed_d * scene_.fluid.spacing_m) makeRoom();
}

/// Corrects density as in the iterations of a substep, but without changing velocities.
template <class Real>
void Simulator<Real>::makeRoom() {
  for (int k = 0; k < kMaxCorrections; ++k) {
    findNeighbours();
    fluid_->updateDensity(particles_, neighbours_);
    if (static_cast<Real>(fluid_->maxDensity()) < Real(1 + kDense)) break;
    fluid_->updateCorrections(particles_, neighbours_);
    respondToCollisions();
    updatePredicted();
    if (bodies()) bodies()->writePredicted(particles_.predicted);
    particles_.position = particles_.predicted;
  }
  fluid_->forget();
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
