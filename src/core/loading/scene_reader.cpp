#include "loading/scene_reader.h"

#include <algorithm>
#include <type_traits>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_keys.h"
#include "loading/block_frames.h"
#include "loading/renamed_keys.h"

namespace ice_ice_baby {

namespace {

constexpr std::size_t kMaxListEntries = 1000;
constexpr std::size_t kMaxBlocks = 10000;  ///< copies included

/// Visitor of describe(): reads one map of the tree into the described struct.
class Reader {
 public:
  Reader(const YAML::Node& map, std::string path) : map_(map), path_(std::move(path)) {
    if (map_.IsDefined() && !map_.IsNull() && !map_.IsMap()) {
      throw InvalidInput(path_ + " must be a map of keys");
    }
  }

  void operator()(const char* name, double& value, Range range, const char*) {
    if (const YAML::Node node = find(name)) value = number(node, keyPath(name), range);
  }

  void operator()(const char* name, int& value, Range range, const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    const double read = number(node, keyPath(name), range);
    if (read != static_cast<double>(static_cast<int>(read))) {
      throw InvalidInput(keyPath(name) + " = " + text(node) + " must be a whole number");
    }
    value = static_cast<int>(read);
  }

  void operator()(const char* name, Vec3d& value, Range range, const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    value = vector(node, keyPath(name), range);
  }

  void operator()(const char* name, Mat3<double>& value, Range range, const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    if (!node.IsSequence() || node.size() != 3) {
      throw InvalidInput(keyPath(name) + " = " + text(node) +
                         " must be three rows of three numbers, as [[1, 0, 0], [0, -1, 0], "
                         "[0, 0, 0]]");
    }
    for (int row = 0; row < 3; ++row) {
      value.row(row) = vector(node[row], keyPath(name) + "." + std::to_string(row), range);
    }
  }

  void operator()(const char* name, bool& value, const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value)) {
      throw InvalidInput(keyPath(name) + " = " + text(node) + " must be true or false");
    }
  }

  void operator()(const char* name, std::string& value, const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    if (!node.IsScalar()) throw InvalidInput(keyPath(name) + " must be a text");
    value = node.Scalar();
  }

  template <class Choice>
  std::enable_if_t<std::is_enum_v<Choice>> operator()(const char* name, Choice& value,
                                                      const char*) {
    const YAML::Node node = find(name);
    if (!node) return;
    const std::vector<std::string> names = choices(value);
    const auto found = std::find(names.begin(), names.end(), text(node));
    if (found == names.end()) {
      throw InvalidInput(keyPath(name) + " = " + text(node) + " must be one of: " + joined(names));
    }
    value = static_cast<Choice>(found - names.begin());
  }

  template <class Params>
  void section(const char* name, Params& params, const char*) {
    Reader reader(find(name), keyPath(name));
    describe(params, reader);
    reader.refuseUnknown();
  }

  template <class Item>
  void list(const char* name, std::vector<Item>& items, const char*) {
    const YAML::Node node = find(name);
    if (!node || node.IsNull()) return;
    if (!node.IsSequence()) throw InvalidInput(keyPath(name) + " must be a list");
    if (node.size() > kMaxListEntries) {
      throw InvalidInput(keyPath(name) + " has " + std::to_string(node.size()) +
                         " entries; at most " + std::to_string(kMaxListEntries) + " are allowed");
    }
    for (std::size_t k = 0; k < node.size(); ++k) {
      Reader reader(node[k], keyPath(name) + "." + std::to_string(k));
      describe(items.emplace_back(), reader);
      reader.refuseUnknown();
    }
  }

  void refuseUnknown() const {
    if (!isMap()) return;
    for (const auto& entry : map_) {
      const std::string name = text(entry.first);
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      const std::string present = renamedKey(name);
      const bool renamed = std::find(known_.begin(), known_.end(), present) != known_.end();
      throw InvalidInput("unknown key " + keyPath(name) +
                         (renamed ? "; did you mean " + keyPath(present) + "?"
                                  : suggestion(name, known_, keyPath(""))));
    }
  }

 private:
  bool isMap() const { return map_.IsDefined() && map_.IsMap(); }

  std::string keyPath(const std::string& name) const {
    return path_.empty() ? name : path_ + "." + name;
  }

  YAML::Node find(const char* name) {
    known_.emplace_back(name);
    return isMap() ? map_[name] : YAML::Node(YAML::NodeType::Undefined);
  }

  static std::string text(const YAML::Node& node) {
    if (node.IsScalar()) return shortened(node.Scalar());
    YAML::Emitter out;
    out << YAML::Flow << node;
    return shortened(out.c_str());
  }

  static double number(const YAML::Node& node, const std::string& key, Range range) {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
      throw InvalidInput(key + " = " + text(node) + " must be a number");
    }
    requireInRange(key, value, range.min, range.max);
    return value;
  }

  static Vec3d vector(const YAML::Node& node, const std::string& key, Range range) {
    if (!node.IsSequence() || node.size() != 3) {
      throw InvalidInput(key + " = " + text(node) + " must be three numbers, as [0, 0, 1]");
    }
    Vec3d value;
    for (int axis = 0; axis < 3; ++axis) {
      value[axis] = number(node[axis], key + "." + std::to_string(axis), range);
    }
    return value;
  }

  const YAML::Node map_;
  std::string path_;
  std::vector<std::string> known_;
};

template <class Item>
void nameItems(std::vector<Item>& list, const std::string& noun) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (list[k].name.empty()) list[k].name = noun + "_" + std::to_string(k);
  }
}

/// What has no name is called container_0, plane_1, source_0 and so on.
void nameAll(Scene& scene) {
  forEachColliderList(scene,
                      [](auto& list, const ColliderKind& kind) { nameItems(list, kind.noun); });
  nameItems(scene.sources, "source");
  nameItems(scene.drains, "drain");
  nameItems(scene.heat_regions, "heat_region");
  nameItems(scene.solids, "solid");
  nameItems(scene.gauges, "gauge");
  nameItems(scene.cameras, "camera");
}

/// Puts a block of its own in place of every copy.
void expandCopies(Scene& scene) {
  std::vector<Block> expanded;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const Vec3d copies = block.copies;
    if (copies != copies.array().floor().matrix() || copies.prod() > kMaxListEntries) {
      throw InvalidInput("blocks." + std::to_string(k) + ".copies = [" + numberText(copies.x()) +
                         ", " + numberText(copies.y()) + ", " + numberText(copies.z()) +
                         "] must be whole numbers, at most " + std::to_string(kMaxListEntries) +
                         " copies together");
    }
    if (double(expanded.size()) + copies.prod() > double(kMaxBlocks)) {
      throw InvalidInput("the blocks with their copies are more than " +
                         std::to_string(kMaxBlocks) + "; lower blocks." + std::to_string(k) +
                         ".copies");
    }
    for (int x = 0; x < copies.x(); ++x) {
      for (int y = 0; y < copies.y(); ++y) {
        for (int z = 0; z < copies.z(); ++z) {
          Block& copy = expanded.emplace_back(block);
          const Vec3d shift = Vec3d(x, y, z).cwiseProduct(block.copies_step_m);
          copy.min_m += shift;
          copy.max_m += shift;
          copy.copies = Vec3d::Ones();
        }
      }
    }
  }
  scene.blocks = std::move(expanded);
}

template <class Params>
void read(const YAML::Node& map, const std::string& path, Params& params) {
  Reader reader(map, path);
  describe(params, reader);
  reader.refuseUnknown();
}

}  // namespace

Scene readScene(const YAML::Node& tree, const SceneHome& home) {
  try {
    // Read twice: the preset and the spacing that the file sets decide what lies beneath its keys.
    Scene chosen;
    read(tree, "", chosen);
    Scene scene;
    applyPreset(scene, chosen.preset, chosen.fluid.spacing_m);
    read(tree, "", scene);
    nameAll(scene);
    expandCopies(scene);
    placeInFrames(scene);
    findMeshFiles(scene, home.folder, home.meshes);
    readMeshFiles(scene);
    validate(scene);
    return scene;
  } catch (const InvalidInput& e) {
    throw InvalidInput(home.origin + ": " + e.what());
  }
}

}  // namespace ice_ice_baby
