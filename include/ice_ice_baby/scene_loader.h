// Scene files: found by name, merged with overrides, checked against scene_keys.h, nothing else.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace YAML {
class Node;
}

namespace ice_ice_baby {

/// One `key=value` of run_scene --set or of the node's overrides: the dotted name of any key of
/// config/default.yaml (list entries by number, `spheres.0.radius_m`) and a YAML value.
struct Override {
  std::string key;
  std::string value;
};

/// Splits "solver.iterations=4". @throws InvalidInput without a "=" or with an empty key
Override parseOverride(const std::string& text);

/// Folder in which scenes are looked up by name: $ICE_ICE_BABY_SCENES, else the one installed with
/// the library, else the one of the source tree.
/// @throws InvalidInput naming the folders and the variable when there is none
std::string sceneFolder();

/// Names of the scenes in sceneFolder(), sorted; then those of its folder verification, whose
/// answer is known, sorted too.
/// @throws InvalidInput as sceneFolder(), and when the folder holds no scene
std::vector<std::string> sceneNames();

/// Reads a scene by name ("dam_break", looked up in sceneFolder()) or by path (ends in .yaml).
/// Keys in force: defaults, under the preset, under the file, under `overrides`.
/// @throws InvalidInput for an unknown scene, malformed YAML, an unknown key, a value out of range
Scene loadScene(const std::string& name_or_path, const std::vector<Override>& overrides = {});

/// The same from YAML text; `origin` names it in messages.
Scene parseScene(const std::string& yaml, const std::vector<Override>& overrides = {},
                 const std::string& origin = "scene");

/// Every key with its default, range and meaning: the text of config/default.yaml.
std::string defaultYaml();

}  // namespace ice_ice_baby
