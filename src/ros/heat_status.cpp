#include "heat_status.h"

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Tolerance for rounding.
constexpr double kAsWanted = 0.999;

}  // namespace

void addHeat(diagnostic_updater::DiagnosticStatusWrapper& status, const Snapshot& now) {
  if (!now.thermal) return;
  const StepReport& report = now.report;
  const bool watched = report.frame > 0 && !report.asleep;
  if (watched && report.thermal_speedup < kAsWanted * now.thermal_speedup_wanted) {
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN,
                        "heat is sped up " + numberText(report.thermal_speedup) +
                            " times instead of " + numberText(now.thermal_speedup_wanted) +
                            " times; lower thermal.speedup or raise solver.substeps");
  }
  status.add("thermal_speedup_wanted", now.thermal_speedup_wanted);
}

}  // namespace ice_ice_baby
