// The warning that a promised error is not kept.
#pragma once

#include <string>

#include "ice_ice_baby/step_report.h"

namespace ice_ice_baby {

/// What a user should know and do if the mean density error of the run is larger than the scene
/// promises, or frames take longer than solver.budget; empty otherwise.
std::string qualityWarning(const StepReport& report);

}  // namespace ice_ice_baby
