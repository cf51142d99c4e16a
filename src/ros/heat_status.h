// Diagnostics of a scene with heat.
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "simulation_thread.h"

namespace ice_ice_baby {

/// Adds nothing for a scene without heat. Warns if heat is slower than thermal.speedup asks for.
void addHeat(diagnostic_updater::DiagnosticStatusWrapper& status, const Snapshot& now);

}  // namespace ice_ice_baby
