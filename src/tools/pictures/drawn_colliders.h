// Containers, plates and balls in pictures of scenes with heat, coloured by their temperature.
#pragma once

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Box that holds everything in the scene that has an end.
Eigen::AlignedBox3f boundsOf(const Scene& scene);

/// Box that holds its colliders but grounds without end; without a container what boundsOf has.
Eigen::AlignedBox3f stageOf(const Scene& scene);

/// Corner k of the inside of a container: bits for x, y, z.
Eigen::Vector3f boxCorner(const Container& container, int k);

/// Those that hide what is behind them: of opacity 1, and balls.
void drawOpaqueColliders(const Simulation& simulation, Canvas& canvas);

/// Edges of containers, floors and plates of lower opacity.
void drawClearColliders(const Simulation& simulation, Canvas& canvas);

}  // namespace ice_ice_baby
