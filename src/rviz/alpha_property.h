// A property of a display: an opacity.
#pragma once

#include <rviz/properties/float_property.h>

namespace ice_ice_baby {

/// From 0 to 1. A change calls the slot `restyle` of `display`, which owns the property.
inline rviz::FloatProperty* makeAlpha(const char* name, float value, const char* meaning,
                                      rviz::Property* display) {
  auto* alpha = new rviz::FloatProperty(name, value, meaning, display, SLOT(restyle()));
  alpha->setMin(0.0F);
  alpha->setMax(1.0F);
  return alpha;
}

}  // namespace ice_ice_baby
