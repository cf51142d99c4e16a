#include "ice_ice_baby/quality_warning.h"

#include <cstdio>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

namespace {

std::string percentText(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * fraction);
  return text;
}

}  // namespace

std::string qualityWarning(const StepReport& report) {
  if (report.quality_met) return {};
  if (report.promised_error == 0.0) {
    return "frames take longer than solver.budget allows, even with the " +
           std::to_string(report.substeps) +
           " substeps that water needs to be stable; use a larger spacing, more threads or a "
           "larger "
           "budget";
  }
  const std::string cure =
      report.substeps >= kMaxSubsteps
          ? std::to_string(report.substeps) +
                " substeps per frame are not enough: raise solver.frame_rate_hz"
          : "set solver.substeps to 0, so that their number follows the error";
  return "the mean density error, " + percentText(report.density_error_run) +
         ", is larger than the " + percentText(report.promised_error) + " asked for; " + cure +
         ", or choose a lower solver.quality";
}

}  // namespace ice_ice_baby
