// The scenes that the node serves: those of files, with what its parameters change and add.
#pragma once

#include <string>

#include "ice_ice_baby/scene.h"
#include "parameters.h"

namespace ice_ice_baby {

/// Loads a scene with the overrides of the node and the links of its robot.
/// @param name of a scene, or path of a .yaml file
/// @param preset "": that of the scene
/// @throws InvalidInput as loadScene and addRobotLinks
Scene loadServedScene(const NodeParameters& parameters, const std::string& name,
                      const std::string& preset);

/// The same for a scene as text, whose meshes have to be in packages.
/// @throws InvalidInput as parseForeignScene and addRobotLinks
Scene parseServedScene(const NodeParameters& parameters, const std::string& yaml);

}  // namespace ice_ice_baby
