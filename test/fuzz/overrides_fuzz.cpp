#include <sstream>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "promises.h"

namespace ice_ice_baby::fuzz {

namespace {

/// One entry in each list, so that every key can be overridden.
constexpr char kScene[] = R"(
fluid: {spacing_m: 0.05}
thermal: {enabled: true}
schedule: [{at_s: 0.01, celsius: -5}]
blocks: [{min_m: [-0.1, -0.1, 0.1], max_m: [0.1, 0.1, 0.3], celsius: -2}]
containers: [{name: tank, size_m: [0.4, 0.4, 0.5]}]
planes: [{name: ground, position_m: [0, 0, -0.2]}]
spheres: [{name: ball, radius_m: 0.06}]
)";

constexpr std::size_t kMaxOverrides = 50;

}  // namespace

void overrides(const std::string& bytes) {
  std::istringstream lines(bytes);
  std::vector<Override> changes;
  try {
    for (std::string line; changes.size() < kMaxOverrides && std::getline(lines, line);) {
      changes.push_back(parseOverride(line));
    }
    runIfSmall(parseScene(kScene, changes, "fuzz.yaml"));
  } catch (const InvalidInput& e) {
    requireReadable(e.what());
  }
}

}  // namespace ice_ice_baby::fuzz
