// Colliders and floating solids in pictures; colliders in scenes with heat coloured by their
// temperature.
#pragma once

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Those that hide what is behind them: grounds of opacity 1, and objects.
void drawOpaqueColliders(const Simulation& simulation, Canvas& canvas);

/// Edges of what holds water, its floor where it is not insulated, grounds of lower opacity.
void drawClearColliders(const Simulation& simulation, Canvas& canvas);

/// The true shapes of floating solids.
void drawSolids(const Simulation& simulation, Canvas& canvas);

/// Of a scene without heat: objects, and edges of what holds water.
void drawPlainColliders(const Simulation& simulation, Canvas& canvas);

}  // namespace ice_ice_baby
