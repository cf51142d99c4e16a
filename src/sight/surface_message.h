// Messages of a surface.
#pragma once

#include <ice_ice_baby/Surface.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "fluid_surface.h"
#include "ice_ice_baby/samples.h"

namespace ice_ice_baby {

/// Surfaces of water and ice, and the particles of steam; without header and `thermal`.
/// @throws InvalidInput if this program makes no surfaces
Surface surfaceMessage(const std::vector<ParticleSample>& particles, double spacing_m);

/// A marker for the water and one for the ice, which replace those sent before: for viewers without
/// the display `ice_ice_baby/Surface`. Coloured as particles are.
visualization_msgs::MarkerArray surfaceMarkers(const Surface& surface);

}  // namespace ice_ice_baby
