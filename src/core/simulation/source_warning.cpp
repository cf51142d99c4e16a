#include "ice_ice_baby/source_warning.h"

#include "flow/sources.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Fraction of the limit from which on the user is warned.
constexpr double kNearlyFull = 0.9;

}  // namespace

std::string sourceWarning(const Scene& scene, const StepReport& report) {
  const double most = scene.limits.max_particles;
  const double particles = double(report.particles);
  const bool nearly_full = particles >= kNearlyFull * most || report.sources_stopped > 0;
  if (!anyOpen(scene.sources) || !nearly_full) return {};
  const std::string share = numberText(particles) +
                            " of limits.max_particles = " + numberText(most) +
                            " particles are in the scene";
  const std::string cure = "; turn sources off, add a drain, or raise the limit";
  if (report.sources_stopped == 0) return "sources will stop soon: " + share + cure;
  return std::to_string(report.sources_stopped) +
         (report.sources_stopped == 1 ? " source has" : " sources have") + " stopped: " + share +
         cure;
}

}  // namespace ice_ice_baby
