// Reads a Scene from a YAML tree. Refuses every key and value that scene_keys.h does not describe.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "ice_ice_baby/scene.h"
#include "loading/mesh_files.h"

namespace ice_ice_baby {

/// Where a scene comes from.
struct SceneHome {
  std::string origin;  ///< its name in messages
  std::string folder;  ///< from which paths of meshes start; "": the current one
  MeshPlaces meshes = MeshPlaces::kAnywhere;
};

/// @throws InvalidInput naming the origin, the key, the value and what is allowed
Scene readScene(const YAML::Node& tree, const SceneHome& home);

}  // namespace ice_ice_baby
