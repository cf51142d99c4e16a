#include "ice_ice_baby/scene_loader.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ice_ice_baby/errors.h"
#include "scene_reader.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxSceneFile_bytes = 1 << 20;

/// Folder within the scene folder, of the scenes whose answer is known.
constexpr char kVerification[] = "verification";

YAML::Node parseYaml(const std::string& text, const std::string& origin) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& e) {
    throw InvalidInput(origin + ": not valid YAML: " + e.what());
  }
}

std::vector<std::string> splitKey(const std::string& key) {
  std::vector<std::string> parts;
  std::stringstream stream(key);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  const bool empty_part = std::find(parts.begin(), parts.end(), "") != parts.end();
  if (parts.empty() || empty_part || key.back() == '.') {
    throw InvalidInput("\"" + key +
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
            const Override& change) {
  const std::string& part = parts[depth];
  const bool last = depth + 1 == parts.size();
  if (node.IsSequence()) {
    if (!isIndex(part) || std::stoul(part) >= node.size()) {
      throw InvalidInput(change.key + ": the list has " + std::to_string(node.size()) +
                         " entries, so \"" + part + "\" must be a number from 0 to " +
                         std::to_string(static_cast<long>(node.size()) - 1));
    }
    const std::size_t index = std::stoul(part);
    if (last) {
      node[index] = parseYaml(change.value, change.key);
    } else {
      setKey(node[index], parts, depth + 1, change);
    }
    return;
  }
  if (node.IsDefined() && !node.IsMap() && !node.IsNull()) {
    throw InvalidInput(change.key + ": no such key, because what stands before \"" + part +
                       "\" is a value");
  }
  if (last) {
    node[part] = parseYaml(change.value, change.key);
    return;
  }
  if (!node[part].IsDefined() || node[part].IsNull()) {
    if (isIndex(parts[depth + 1])) {
      throw InvalidInput(change.key + ": the scene itself sets no " + part +
                         " to change a part of; set all of it, as " + part + "=[...]");
    }
    node[part] = YAML::Node(YAML::NodeType::Map);
  }
  setKey(node[part], parts, depth + 1, change);
}

std::string readFile(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InvalidInput("no scene file " + path.string());
  }
  if (fs::file_size(path, error) > kMaxSceneFile_bytes) {
    throw InvalidInput("scene file " + path.string() + " is larger than 1 MiB");
  }
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw InvalidInput("cannot read scene file " + path.string());
  return text.str();
}

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool isPath(const std::string& name) {
  const fs::path path(name);
  return path.extension() == ".yaml" || path.extension() == ".yml" || path.has_parent_path();
}

}  // namespace

Override parseOverride(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InvalidInput("\"" + text + "\" is not of the form key=value, as solver.iterations=4");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::string sceneFolder() {
  if (const char* chosen = std::getenv("ICE_ICE_BABY_SCENES")) return chosen;
  for (const char* folder : {IIB_SOURCE_SCENES, IIB_INSTALLED_SCENES}) {
    if (fs::is_directory(folder)) return folder;
  }
  return IIB_INSTALLED_SCENES;
}

std::vector<std::string> sceneNames() {
  const fs::path folder = sceneFolder();
  std::vector<std::string> names = namesIn(folder);
  const std::vector<std::string> known = namesIn(folder / kVerification);
  names.insert(names.end(), known.begin(), known.end());
  return names;
}

Scene loadScene(const std::string& name_or_path, const std::vector<Override>& overrides) {
  if (isPath(name_or_path)) {
    return parseScene(readFile(name_or_path), overrides, name_or_path);
  }
  const std::vector<std::string> names = sceneNames();
  if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
    throw InvalidInput("no scene \"" + shortened(name_or_path) + "\"" +
                       suggestion(name_or_path, names) + "; or the path of a .yaml file");
  }
  const std::string file = name_or_path + ".yaml";
  const fs::path ordinary = fs::path(sceneFolder()) / file;
  const fs::path known = fs::path(sceneFolder()) / kVerification / file;
  return parseScene(readFile(fs::exists(ordinary) ? ordinary : known), overrides, name_or_path);
}

Scene parseScene(const std::string& yaml, const std::vector<Override>& overrides,
                 const std::string& origin) {
  YAML::Node tree = parseYaml(yaml, origin);
  if (tree.IsNull()) tree = YAML::Node(YAML::NodeType::Map);
  if (!tree.IsMap())
    throw InvalidInput(origin + ": a scene is a map of keys; see config/default.yaml");
  try {
    for (const Override& change : overrides) {
      const std::vector<std::string> parts = splitKey(change.key);
      setKey(tree, parts, 0, change);
    }
    return readScene(tree, origin);
  } catch (const YAML::Exception& e) {
    throw InvalidInput(origin + ": " + e.what());
  }
}

}  // namespace ice_ice_baby
