#include "requests.h"

#include <algorithm>

#include "geometry.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {

namespace {

/// @throws InvalidInput for any shape but box and sphere
BlockShape shapeOf(const std::string& name) {
  if (name == "box") return BlockShape::kBox;
  if (name == "sphere") return BlockShape::kSphere;
  throw InvalidInput("shape = \"" + shortened(name) + "\" must be one of: box, sphere");
}

}  // namespace

void requireSceneName(const std::string& name) {
  const std::vector<std::string> names = sceneNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InvalidInput("no scene \"" + shortened(name) + "\"" + suggestion(name, names));
}

HeatedRegion regionOf(const HeatRegion::Request& request) {
  HeatedRegion region;
  region.shape = shapeOf(request.shape);
  region.centre_m = vectorOf(request.centre);
  region.size_m = vectorOf(request.size);
  region.power_w = request.power_w;
  region.duration_s = request.duration_s;
  return region;
}

}  // namespace ice_ice_baby
