#include "ice_ice_baby/scene_loader.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "ice_ice_baby/errors.h"
#include "loading/block_frames.h"
#include "loading/mesh_files.h"
#include "loading/scene_files.h"
#include "loading/scene_reader.h"
#include "loading/yaml_text.h"

namespace ice_ice_baby {

namespace {

/// More levels than any key of config/default.yaml has.
constexpr std::size_t kMaxKeyParts = 10;

std::vector<std::string> splitKey(const std::string& key) {
  std::vector<std::string> parts;
  std::stringstream stream(key);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  const bool empty_part = std::find(parts.begin(), parts.end(), "") != parts.end();
  if (parts.empty() || empty_part || key.back() == '.' || parts.size() > kMaxKeyParts) {
    throw InvalidInput("\"" + shortened(key) +
                       "\" is not a key: give names between single dots, as "
                       "solver.iterations");
  }
  return parts;
}

bool isIndex(const std::string& part) {
  return !part.empty() && part.size() < 9 &&
         part.find_first_not_of("0123456789") == std::string::npos;
}

void setKey(YAML::Node node, const std::vector<std::string>& parts, std::size_t depth,
            const Override& change);

void setInList(YAML::Node list, const std::vector<std::string>& parts, std::size_t depth,
               const Override& change) {
  const std::string& part = parts[depth];
  if (!isIndex(part) || std::stoul(part) >= list.size()) {
    throw InvalidInput(shortened(change.key) + ": the list has " + std::to_string(list.size()) +
                       " entries, so \"" + shortened(part) + "\" must be a number from 0 to " +
                       std::to_string(static_cast<long>(list.size()) - 1));
  }
  const std::size_t index = std::stoul(part);
  if (depth + 1 == parts.size()) {
    list[index] = parseYaml(change.value, shortened(change.key));
  } else {
    setKey(list[index], parts, depth + 1, change);
  }
}

void setKey(YAML::Node node, const std::vector<std::string>& parts, std::size_t depth,
            const Override& change) {
  if (node.IsSequence()) return setInList(node, parts, depth, change);
  const std::string& part = parts[depth];
  if (node.IsDefined() && !node.IsMap() && !node.IsNull()) {
    throw InvalidInput(shortened(change.key) + ": no such key, because what stands before \"" +
                       shortened(part) + "\" is a value");
  }
  if (depth + 1 == parts.size()) {
    node[part] = parseYaml(change.value, shortened(change.key));
    return;
  }
  if (!node[part].IsDefined() || node[part].IsNull()) {
    if (isIndex(parts[depth + 1])) {
      throw InvalidInput(shortened(change.key) + ": the scene itself sets no " + shortened(part) +
                         " to change a part of; set all of it, as " + shortened(part) + "=[...]");
    }
    node[part] = YAML::Node(YAML::NodeType::Map);
  }
  setKey(node[part], parts, depth + 1, change);
}

Scene parse(const std::string& yaml, const std::vector<Override>& overrides,
            const SceneHome& home) {
  const std::string& origin = home.origin;
  YAML::Node tree = parseYaml(yaml, origin);
  if (tree.IsNull()) tree = YAML::Node(YAML::NodeType::Map);
  if (!tree.IsMap())
    throw InvalidInput(origin + ": a scene is a map of keys; see config/default.yaml");
  try {
    for (const Override& change : overrides) {
      const std::vector<std::string> parts = splitKey(change.key);
      setKey(tree, parts, 0, change);
    }
    return readScene(tree, home);
  } catch (const YAML::Exception& e) {
    throw InvalidInput(origin + ": " + shortened(e.what()));
  }
}

}  // namespace

Override parseOverride(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InvalidInput("\"" + shortened(text) +
                       "\" is not of the form key=value, as solver.iterations=4");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

Scene loadScene(const std::string& name_or_path, const std::vector<Override>& overrides) {
  const bool by_path = isScenePath(name_or_path);
  const std::string file = by_path ? name_or_path : sceneFile(name_or_path);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return parse(
      readSceneFile(file), overrides,
      {shortened(name_or_path), folder, by_path ? MeshPlaces::kAnywhere : MeshPlaces::kFolder});
}

void completeScene(Scene& scene) {
  placeInFrames(scene);
  findMeshFiles(scene, "", MeshPlaces::kAnywhere);
  readMeshFiles(scene);
  validate(scene);
}

Scene parseScene(const std::string& yaml, const std::vector<Override>& overrides,
                 const std::string& origin) {
  return parse(yaml, overrides, {origin, "", MeshPlaces::kAnywhere});
}

Scene parseForeignScene(const std::string& yaml, const std::vector<Override>& overrides,
                        const std::string& origin) {
  return parse(yaml, overrides, {origin, "", MeshPlaces::kPackages});
}

}  // namespace ice_ice_baby
