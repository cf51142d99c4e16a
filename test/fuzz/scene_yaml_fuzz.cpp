#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "promises.h"

namespace ice_ice_baby::fuzz {

void sceneYaml(const std::string& bytes) {
  try {
    runIfSmall(parseScene(bytes, {}, "fuzz.yaml"));
  } catch (const InvalidInput& e) {
    requireReadable(e.what());
  }
}

}  // namespace ice_ice_baby::fuzz
