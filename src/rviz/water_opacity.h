// Water in the view becomes more opaque as it freezes, as in the paper.
#pragma once

#include <string>

namespace rviz {
class DisplayGroup;
}

namespace ice_ice_baby {

/// Opacity of particles at a strictness from 0 (water, translucent) to 1 (ice, opaque).
float waterOpacity(double strictness);

/// Sets the opacity of every point cloud display of `displays` that shows `topic`. The whole cloud
/// changes at once: opacity per point would make rviz draw opaque ice without depth.
void showOpacity(rviz::DisplayGroup* displays, const std::string& topic, float opacity);

}  // namespace ice_ice_baby
