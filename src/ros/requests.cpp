#include "requests.h"

#include <algorithm>

#include "geometry.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {

namespace {

/// @throws InvalidInput for a shape that no heated region has
BlockShape shapeOf(const std::string& name) {
  if (name == "box") return BlockShape::kBox;
  if (name == "ball") return BlockShape::kBall;
  throw InvalidInput("shape = \"" + shortened(name) + "\" must be one of: box, ball");
}

}  // namespace

void requireSceneName(const std::string& name) {
  const std::vector<std::string> names = sceneNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InvalidInput("no scene \"" + shortened(name) + "\"" + suggestion(name, names));
}

HeatRegion regionOf(const ApplyHeat::Request& request) {
  HeatRegion region;
  region.shape = shapeOf(request.shape);
  region.centre_m = vectorOf(request.centre);
  region.size_m = vectorOf(request.size);
  region.power_w = request.power_w;
  region.duration_s = request.duration_s;
  return region;
}

}  // namespace ice_ice_baby
