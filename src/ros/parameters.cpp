#include "parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ice_ice_baby/errors.h"
#include "override_tree.h"
#include "text_values.h"

namespace ice_ice_baby {

namespace {

using XmlRpc::XmlRpcValue;

/// Visitor of describe(): reads members of a struct of the parameter server.
class Reader {
 public:
  explicit Reader(const XmlRpcValue& tree) : tree_(tree) {}

  void operator()(const char* name, double& value, Range range, const char*) {
    if (find(name)) value = number(name, tree_[name], range);
  }

  void operator()(const char* name, int& value, Range range, const char*) {
    if (!find(name)) return;
    const double read = number(name, tree_[name], range);
    if (read != static_cast<double>(static_cast<int>(read))) {
      refuse(name, "must be a whole number");
    }
    value = static_cast<int>(read);
  }

  void operator()(const char* name, Vec3d& value, Range range, const char*) {
    if (!find(name)) return;
    if (const std::optional<Vec3d> read = vectorIn(textOf(tree_[name]))) {
      for (const double part : *read) {
        requireInRange(std::string("parameter ~") + name, part, range.min, range.max);
      }
      value = *read;
      return;
    }
    if (tree_[name].getType() != XmlRpcValue::TypeArray || tree_[name].size() != 3) {
      refuse(name, "must be three numbers, as [0, 0, 1]");
    }
    for (int axis = 0; axis < 3; ++axis) {
      value[axis] = number(name, tree_[name][axis], range);
    }
  }

  void operator()(const char* name, bool& value, const char*) {
    if (!find(name)) return;
    if (tree_[name].getType() != XmlRpcValue::TypeBoolean) refuse(name, "must be true or false");
    value = static_cast<const bool&>(tree_[name]);
  }

  void operator()(const char* name, std::string& value, const char*) {
    if (!find(name)) return;
    if (tree_[name].getType() != XmlRpcValue::TypeString) {
      refuse(name,
             "must be a text; a number as text needs quotes in YAML, type=\"str\" in a "
             "launch file, and cannot be given as an argument of the node");
    }
    value = static_cast<const std::string&>(tree_[name]);
  }

  template <class Choice>
  std::enable_if_t<std::is_enum_v<Choice>> operator()(const char* name, Choice& value,
                                                      const char* meaning) {
    const std::vector<std::string> names = choices(value);
    std::string text = names[static_cast<std::size_t>(value)];
    (*this)(name, text, meaning);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) refuse(name, "must be one of: " + joined(names));
    value = static_cast<Choice>(found - names.begin());
  }

  bool find(const char* name) {
    known_.emplace_back(name);
    return tree_.getType() == XmlRpcValue::TypeStruct && tree_.hasMember(name);
  }

  void refuseUnknown() const {
    if (tree_.getType() != XmlRpcValue::TypeStruct) return;
    for (auto entry = tree_.begin(); entry != tree_.end(); ++entry) {
      const std::string& name = entry->first;
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      throw InvalidInput("unknown parameter ~" + shortened(name) +
                         suggestion(shortened(name), known_, "~"));
    }
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& allowed) const {
    throw InvalidInput("parameter ~" + name + " = " + shortened(yamlText(tree_[name], "~" + name)) +
                       " " + allowed);
  }

 private:
  /// "" for a value that is no text.
  static std::string textOf(const XmlRpcValue& value) {
    const bool text = value.getType() == XmlRpcValue::TypeString;
    return text ? static_cast<const std::string&>(value) : std::string();
  }

  double number(const std::string& name, const XmlRpcValue& value, Range range) const {
    const bool whole = value.getType() == XmlRpcValue::TypeInt;
    const std::optional<double> text = numberIn(textOf(value));
    if (!whole && !text && value.getType() != XmlRpcValue::TypeDouble) {
      refuse(name, "must be a number");
    }
    const double read = text    ? *text
                        : whole ? double(static_cast<const int&>(value))
                                : static_cast<const double&>(value);
    requireInRange("parameter ~" + name, read, range.min, range.max);
    return read;
  }

  const XmlRpcValue tree_;
  std::vector<std::string> known_;
};

/// Visitor of describe(): writes one row of the table per parameter.
class TableWriter {
 public:
  void operator()(const char* name, double& value, Range range, const char* meaning) {
    row(name, plain(value), rangeText(range), meaning);
  }
  void operator()(const char* name, int& value, Range range, const char* meaning) {
    row(name, plain(value), rangeText(range), meaning);
  }
  void operator()(const char* name, Vec3d& value, Range range, const char* meaning) {
    row(name,
        "[" + numberText(value.x()) + ", " + numberText(value.y()) + ", " + numberText(value.z()) +
            "]",
        rangeText(range), meaning);
  }
  void operator()(const char* name, bool& value, const char* meaning) {
    row(name, value ? "true" : "false", "true, false", meaning);
  }
  void operator()(const char* name, std::string& value, const char* meaning) {
    row(name, value.empty() ? "\"\"" : value, "text", meaning);
  }
  template <class Choice>
  std::enable_if_t<std::is_enum_v<Choice>> operator()(const char* name, Choice& value,
                                                      const char* meaning) {
    const std::vector<std::string> names = choices(value);
    row(name, names[static_cast<std::size_t>(value)], joined(names), meaning);
  }

  std::string text() const { return out_.str(); }

  void row(const std::string& name, const std::string& fallback, const std::string& range,
           const std::string& meaning) {
    out_ << "| `" << name << "` | " << fallback << " | " << range << " | " << unit(name) << " | "
         << meaning << " |\n";
  }

 private:
  static std::string rangeText(Range range) { return plain(range.min) + " to " + plain(range.max); }

  /// Whole numbers without an exponent.
  static std::string plain(double value) {
    return value == std::round(value) ? std::to_string(std::lround(value)) : numberText(value);
  }

  /// Unit by the ending of the name, which carries it.
  static std::string unit(const std::string& name) {
    const auto ends = [&](const std::string& end) {
      return name.size() > end.size() &&
             name.compare(name.size() - end.size(), end.size(), end) == 0;
    };
    if (ends("_hz")) return "Hz";
    if (ends("_rad_s")) return "rad/s";
    if (ends("_m_s2")) return "m/s²";
    if (ends("_m_s")) return "m/s";
    if (ends("_deg")) return "degrees";
    if (ends("_m")) return "m";
    if (ends("_period") || ends("_s")) return "s";
    return "";
  }

  std::ostringstream out_;
};

/// Two nodes in two namespaces have frames of their own. @param node full name
std::string defaultSceneFrame(const std::string& node) {
  const std::size_t end = node.rfind('/');
  const std::string space = end == std::string::npos || end == 0 ? "" : node.substr(1, end);
  return space + "ice_ice_baby/scene";
}

}  // namespace

NodeParameters readParameters(const XmlRpcValue& tree, const std::string& node) {
  if (tree.valid() && tree.getType() != XmlRpcValue::TypeStruct) {
    throw InvalidInput("the parameters of the node = " + shortened(yamlText(tree, "~")) +
                       " must be a map of names and values; rosparam delete NAME_OF_THE_NODE");
  }
  NodeParameters parameters;
  Reader reader(tree);
  describe(parameters, reader);
  if (reader.find("overrides")) parameters.overrides = readOverrides(tree["overrides"]);
  reader.refuseUnknown();
  const std::vector<std::string> presets = choices(Preset{});
  if (!parameters.preset.empty() &&
      std::find(presets.begin(), presets.end(), parameters.preset) == presets.end()) {
    reader.refuse("preset", "must be \"\" or one of: " + joined(presets));
  }
  if (!reader.find("scene_frame")) parameters.scene_frame = defaultSceneFrame(node);
  requireFrameName("parameter ~frame_id", parameters.frame_id);
  requireFrameName("parameter ~scene_frame", parameters.scene_frame);
  if (parameters.frame_id == parameters.scene_frame) {
    throw InvalidInput("parameters ~frame_id and ~scene_frame are both " + parameters.frame_id +
                       "; give the scene a frame of its own, as ice_ice_baby/scene");
  }
  return parameters;
}

std::vector<Override> overridesFor(const NodeParameters& parameters, const std::string& preset) {
  std::vector<Override> all = parameters.overrides;
  if (preset.empty()) return all;
  const std::vector<std::string> presets = choices(Preset());
  if (std::find(presets.begin(), presets.end(), preset) == presets.end()) {
    throw InvalidInput("preset = \"" + shortened(preset) + "\" must be one of: " + joined(presets));
  }
  all.push_back({"preset", preset});
  return all;
}

std::string parameterTable() {
  NodeParameters defaults;
  TableWriter writer;
  describe(defaults, writer);
  writer.row(
      "overrides", "{}", "any key of a scene file",
      "tree of keys that replace those of every scene, for example overrides/solver/iterations");
  return "| parameter | default | range | unit | meaning |\n| --- | --- | --- | --- | --- |\n" +
         writer.text();
}

}  // namespace ice_ice_baby
