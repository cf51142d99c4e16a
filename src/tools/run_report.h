// What run_scene tells of a run: the JSON of --report, the table of --profile and the verdict.
#pragma once

#include <string>
#include <vector>

#include "metrics/error_metrics.h"
#include "sequences/sequence_folders.h"

namespace ice_ice_baby {

/// Sums over the frames of a run.
struct RunRecord {
  std::string precision;
  int threads = 0;
  double started_s = 0.0;
  double wall_time_s = 0.0;
  std::uint64_t steps = 0;
  std::uint64_t speed_limited = 0;
  std::uint64_t correction_limited = 0;
  std::size_t max_speed_limited = 0;
  double fastest_m_s = 0.0;
  double residual_speed_m_s = 0.0;
  double density_error_mean = 0.0;
  double density_error_max = 0.0;
  double density_error_own_kernel_mean = 0.0;
  std::size_t samples = 0;
  std::size_t escaped = 0;
  double max_ice = 0.0;
  std::size_t max_ice_bodies = 0;
  std::size_t max_steam = 0;
  bool stopped = false;
  std::vector<WrittenSequence> written;
  std::vector<ErrorMetric> metrics;
  std::vector<ColliderWrench> wrenches;  ///< means of the last half second; empty if not measured

  void addFrame(const StepReport& report);
  void addSample(const StepReport& report, const DensityError& error);
  /// Seconds of simulated time per second of wall time, at simulated time `time_s`.
  double realTimeFactor(double time_s) const;
};

/// Every number of a run, as step_report.h has those of a frame. Its metrics describe themselves.
template <class Visitor>
void describe(const RunRecord& r, Visitor&& visit) {
  visit("precision", r.precision, "float or double");
  visit("threads", r.threads, "of the solver");
  visit("started_s", r.started_s,
        "simulated time at which the run began: 0, or that of its checkpoint");
  visit("wall_time_s", r.wall_time_s, "that all frames took to compute");
  visit("steps", r.steps, "substeps of all frames");
  visit("speed_limited", r.speed_limited,
        "particles and ice bodies slowed to solver.max_speed_m_s, sum over the frames");
  visit("correction_limited", r.correction_limited,
        "corrections cut to solver.max_correction_h, sum over the frames");
  visit("max_speed_limited", r.max_speed_limited,
        "particles and ice bodies slowed to solver.max_speed_m_s, maximum over the frames");
  visit("fastest_m_s", r.fastest_m_s, "of any particle at the end of any frame");
  visit("residual_speed_m_s", r.residual_speed_m_s,
        "root mean square over the particles and the last half second");
  visit("density_error_mean", r.density_error_mean,
        "mean over the samples of the mean, measured with the cubic spline and h = 2 d");
  visit("density_error_max", r.density_error_max,
        "mean over the samples of the maximum, measured with the cubic spline and h = 2 d");
  visit("density_error_own_kernel_mean", r.density_error_own_kernel_mean,
        "mean over the samples of the mean, measured with the solver's own kernel");
  visit("samples", r.samples, "frames at which errors were measured");
  visit("escaped", r.escaped, "particles outside their closed container, maximum over the samples");
  visit("max_ice", r.max_ice, "share by mass, maximum over the frames");
  visit("max_ice_bodies", r.max_ice_bodies, "rigid bodies of ice, maximum over the frames");
  visit("max_steam", r.max_steam, "particles, maximum over the frames");
  visit("stopped", r.stopped, "by a signal, before its end");
}

/// Why the run counts as unstable, or "" when it does not.
std::string instability(const RunRecord& record, const StepReport& report);

/// Makes the file, so that a run does not end in a report that cannot be kept. `what` names it.
/// @throws InvalidInput when it cannot be written
void requireWritable(const std::string& path, const std::string& what);

/// Writes the JSON report. @throws InvalidInput when the file cannot be written
void writeReport(const std::string& path, const Simulation& simulation, const RunRecord& record);

/// Table of the stages: calls, time, share, bytes.
std::string profileTable(const Simulation& simulation);

}  // namespace ice_ice_baby
