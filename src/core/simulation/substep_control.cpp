#include "simulation/substep_control.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

/// Share of the promised error of a quality from which on it is followed, in the mean over the run
/// or, before that is over, over the first frames.
constexpr double kWatched = 0.6, kFirstFrames = 60.0;
/// In a substep water moves at most this far, in spacings: twice its root mean square speed.
constexpr double kMaxStep_d = 1.0;
/// The same for water under pressure, over the square root of the promised error: 0.2 at 0.2 %.
constexpr double kPressedStep_d = 4.47;
/// With a budget, a smaller error than this is not worth the time: the promise of `accurate`.
constexpr double kSmallEnough = 0.0003;

/// Distance that water moves in a frame, in spacings.
double frameStep_d(const Scene& scene, const StepReport& report) {
  return 2.0 * report.rms_speed_m_s / (scene.solver.frame_rate_hz * scene.fluid.spacing_m);
}

/// Substeps per frame that keep water stable.
double stableSubsteps(const Scene& scene, const StepReport& report) {
  return std::max<double>(scene.substepsForFall(), frameStep_d(scene, report) / kMaxStep_d);
}

}  // namespace

SubstepControl::SubstepControl(const Scene& scene)
    : substeps_(scene.substeps()), fewest_(scene.fewestSubsteps()) {}

/// Keeps the error, and the distance that water moves, below bounds. The error is proportional to
/// the square of the substep. More substeps make water stiffer, which adds energy if it is
/// compressed at that moment. So with a quality their number rises one by one with the speed of
/// water under pressure, before it is compressed, and follows the error only while that of the run
/// comes near the promise. It falls by one per frame at most, so that a calm frame does not leave
/// too few for the next one.
void SubstepControl::follow(const Scene& scene, const StepReport& report) {
  const bool budgeted = scene.solver.budget > 0.0;
  const double wanted = budgeted ? wantedForBudget(scene, report) : wantedForError(scene, report);
  const double fewest = std::max(fewest_, substeps_ - 1);
  const double max = std::min<double>(kMaxSubsteps, 2 * substeps_);
  substeps_ = static_cast<int>(std::clamp(std::ceil(wanted), std::min(fewest, max), max));
}

double SubstepControl::wantedForError(const Scene& scene, const StepReport& report) const {
  const double target = scene.solver.target_error;
  const double for_error = substeps_ * std::sqrt(report.density_error_mean / target);
  if (fewest_ == kMinSubsteps) return std::max(for_error, stableSubsteps(scene, report));

  const double frames = double(report.frame);
  const double run_error = report.density_error_run * frames / std::max(frames, kFirstFrames);
  const double step_d = frameStep_d(scene, report), for_fall = scene.substepsForFall();
  const double for_speed =
      std::min(step_d / (kPressedStep_d * std::sqrt(target)), for_error / std::sqrt(kWatched));
  const double wanted = std::max(for_fall, std::min(for_speed, substeps_ + 1.0));
  return run_error > kWatched * target ? std::max(wanted, for_error) : wanted;
}

/// As many as fit; never fewer than keep water stable.
double SubstepControl::wantedForBudget(const Scene& scene, const StepReport& report) const {
  const double frame_s = scene.solver.budget / scene.solver.frame_rate_hz;
  const double fit = std::floor(frame_s / substep_wall_s_);
  const double for_error = substeps_ * std::sqrt(report.density_error_mean / kSmallEnough);
  return std::max(stableSubsteps(scene, report), std::min({fit, for_error, substeps_ + 1.0}));
}

void SubstepControl::limit(const Scene& scene, const StepReport& report, int max) {
  const int stable = static_cast<int>(std::ceil(stableSubsteps(scene, report)));
  substeps_ = std::min(substeps_, std::max(max, stable));
}

void SubstepControl::measure(const Scene& scene, double frame_wall_s) {
  const double frames = std::min(double(++measured_), scene.solver.frame_rate_hz);
  frame_wall_s_ += (frame_wall_s - frame_wall_s_) / frames;
  substep_wall_s_ += (frame_wall_s / substeps_ - substep_wall_s_) / frames;
}

bool SubstepControl::withinBudget(const Scene& scene) const {
  return scene.solver.budget == 0.0 ||
         frame_wall_s_ * scene.solver.frame_rate_hz <= scene.solver.budget;
}

}  // namespace ice_ice_baby
