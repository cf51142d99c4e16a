// What an operator should know of a scene with heat.
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "simulation_thread.h"

namespace ice_ice_baby {

/// Adds nothing for a scene without heat. Warns where heat passes slower than the scene asks.
void addHeat(diagnostic_updater::DiagnosticStatusWrapper& status, const Snapshot& now);

}  // namespace ice_ice_baby
