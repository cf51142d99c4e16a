// Loads scene files: finds them by name, merges overrides, checks every key and value.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace YAML {
class Node;
}

namespace ice_ice_baby {

/// A `key=value` of run_scene --set or of the node's overrides: the dotted name of a key of
/// config/default.yaml (list entries by index, as in `spheres.0.radius_m`) and a YAML value.
struct Override {
  std::string key;
  std::string value;
};

/// Splits text such as "solver.iterations=4". @throws InvalidInput if "=" or the key is missing
Override parseOverride(const std::string& text);

/// Folder in which scenes are looked up by name: $ICE_ICE_BABY_SCENES, else the one installed with
/// the library, else the one of the source tree.
/// @throws InvalidInput naming the folders and the variable when there is none
std::string sceneFolder();

/// Names of the scenes in sceneFolder(), sorted, followed by those in its folder `verification`,
/// sorted too.
/// @throws InvalidInput as sceneFolder(), and when the folder holds no scene
std::vector<std::string> sceneNames();

/// Loads a scene by name ("dam_break", in sceneFolder()) or by path (which ends in .yaml). Later
/// sources override earlier ones: defaults, preset, file, `overrides`.
/// @throws InvalidInput for an unknown scene, malformed YAML, an unknown key, a value out of range
Scene loadScene(const std::string& name_or_path, const std::vector<Override>& overrides = {});

/// Loads a scene from YAML text; `origin` is its name in messages.
Scene parseScene(const std::string& yaml, const std::vector<Override>& overrides = {},
                 const std::string& origin = "scene");

/// Loads a scene from YAML text whose author may not choose files: meshes only from package://.
Scene parseForeignScene(const std::string& yaml, const std::vector<Override>& overrides = {},
                        const std::string& origin = "scene");

/// Makes a scene that was changed in code ready to run: places the blocks that name a frame, reads
/// the meshes that name a file and have no triangles yet, and checks everything as loadScene does.
/// @throws InvalidInput as loadScene
void completeScene(Scene& scene);

/// Every key with its default, range and meaning: the text of config/default.yaml.
std::string defaultYaml();

}  // namespace ice_ice_baby
