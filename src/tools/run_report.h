// What run_scene tells of a run: the JSON of --report, the table of --profile and the verdict.
#pragma once

#include <string>
#include <vector>

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// Sums over the frames of a run.
struct RunRecord {
  std::string precision;
  int threads = 0;
  double started_s = 0.0;  ///< simulated time at which it began: 0, or that of its checkpoint
  double wall_time_s = 0.0;
  std::uint64_t steps = 0;  ///< substeps
  std::uint64_t speed_limited = 0;
  std::uint64_t correction_limited = 0;
  std::size_t peak_limited = 0;   ///< most particles slowed by the speed limit in one frame
  double fastest_m_s = 0.0;       ///< of any particle at the end of any frame
  double density_error_mean = 0;  ///< mean over the samples of the mean, cubic-spline yardstick
  double density_error_max = 0;   ///< mean over the samples of the maximum
  double own_error_mean = 0;      ///< the same mean in the solver's own kernel
  double residual_speed_m_s = 0;  ///< root mean square over the last half second, sleep aside
  std::size_t samples = 0;
  std::size_t escaped = 0;         ///< the most in any sample
  double most_ice = 0.0;           ///< share by mass; from here on the most in any frame
  std::size_t max_ice_bodies = 0;  ///< of rigid ice
  std::size_t most_steam = 0;      ///< particles
  std::vector<ErrorMetric> metrics;
  bool stopped = false;  ///< by somebody, before its end

  void addFrame(const StepReport& report);
  void addSample(const StepReport& report, const DensityError& error);
  /// Seconds of simulated time per second of wall time, at simulated time `time_s`.
  double realTimeFactor(double time_s) const;
};

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
