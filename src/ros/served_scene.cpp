#include "served_scene.h"

#include "ice_ice_baby/scene_loader.h"
#include "robot_links.h"

namespace ice_ice_baby {

Scene loadServedScene(const NodeParameters& parameters, const std::string& name,
                      const std::string& preset) {
  Scene scene = loadScene(name, overridesFor(parameters, preset));
  const std::vector<std::string> patterns = linkPatterns(parameters.links);
  if (patterns.empty()) return scene;
  addRobotLinks(scene, parameters.robot_description, patterns);
  completeScene(scene);
  return scene;
}

}  // namespace ice_ice_baby
