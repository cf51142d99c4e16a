// Reads a Scene from a YAML tree. Refuses every key and value that scene_keys.h does not describe.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// @throws InvalidInput naming `origin`, the key, the value and what is allowed
Scene readScene(const YAML::Node& tree, const std::string& origin);

}  // namespace ice_ice_baby
