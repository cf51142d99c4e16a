#include "served_scene.h"

#include "ice_ice_baby/scene_loader.h"
#include "robot_links.h"

namespace ice_ice_baby {

namespace {

Scene withLinks(const NodeParameters& parameters, Scene scene) {
  const std::vector<std::string> patterns = linkPatterns(parameters.links);
  if (patterns.empty()) return scene;
  addRobotLinks(scene, parameters.robot_description, patterns);
  completeScene(scene);
  return scene;
}

}  // namespace

Scene loadServedScene(const NodeParameters& parameters, const std::string& name,
                      const std::string& preset) {
  return withLinks(parameters, loadScene(name, overridesFor(parameters, preset)));
}

Scene parseServedScene(const NodeParameters& parameters, const std::string& yaml) {
  const std::vector<Override> overrides = overridesFor(parameters, parameters.preset);
  return withLinks(parameters, parseForeignScene(yaml, overrides));
}

}  // namespace ice_ice_baby
