#include "loading/heat_regions_check.h"

#include "base/item_names.h"

namespace ice_ice_baby {

void requireHeatRegions(const Scene& scene) {
  const std::vector<HeatRegionParams>& regions = scene.heat_regions;
  requireInRange("number of heat_regions", double(regions.size()), 0.0, double(kMaxHeatRegions));
  requireNames(regions, "heat region");
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const std::string words = wordsFor("heat_regions", k, regions[k]);
    if (!scene.thermal.enabled) {
      throw InvalidInput(words + " needs a scene with heat; set thermal.enabled to true");
    }
    if (regions[k].shape == BlockShape::kCylinder) {
      throw InvalidInput(words + ".shape = cylinder must be one of: box, sphere");
    }
    if (regions[k].power_w == 0.0) {
      throw InvalidInput(words + ".power_w = 0 must be above 0 to heat, or below 0 to cool");
    }
    requireFollowFrame(regions[k], "heat region");
  }
}

}  // namespace ice_ice_baby
