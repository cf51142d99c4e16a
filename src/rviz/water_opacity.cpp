#include "water_opacity.h"

#include <rviz/display.h>
#include <rviz/display_group.h>

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

float waterOpacity(double strictness) {
  constexpr double kLiquid = 0.6;
  return static_cast<float>(kLiquid + (1.0 - kLiquid) * std::clamp(strictness, 0.0, 1.0));
}

void showOpacity(rviz::DisplayGroup* displays, const std::string& topic, float opacity) {
  for (int k = 0; k < displays->numDisplays(); ++k) {
    rviz::Display* display = displays->getDisplayAt(k);
    if (display->getClassId() != "rviz/PointCloud2") continue;
    if (display->subProp("Topic")->getValue().toString().toStdString() != topic) continue;
    rviz::Property* alpha = display->subProp("Alpha");
    if (std::abs(alpha->getValue().toFloat() - opacity) > 1e-3f) alpha->setValue(opacity);
  }
}

}  // namespace ice_ice_baby
