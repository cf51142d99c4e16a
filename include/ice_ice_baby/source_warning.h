// The warning that sources stop, or will stop, because the scene is full.
#pragma once

#include <string>

#include "ice_ice_baby/scene.h"
#include "ice_ice_baby/step_report.h"

namespace ice_ice_baby {

/// What a user should know and do if a source is open and the particles are at least 90 % of
/// limits.max_particles; empty otherwise.
std::string sourceWarning(const Scene& scene, const StepReport& report);

}  // namespace ice_ice_baby
