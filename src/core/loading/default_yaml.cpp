// Writes config/default.yaml from the descriptions in params.h and scene_keys.h.
#include <sstream>
#include <type_traits>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_keys.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {

namespace {

class Writer {
 public:
  Writer(std::ostream& out, std::string indent) : out_(out), indent_(std::move(indent)) {}

  void operator()(const char* name, double& value, Range range, const char* meaning) {
    line(name, numberText(value), meaning, rangeText(range));
  }
  void operator()(const char* name, int& value, Range range, const char* meaning) {
    line(name, std::to_string(value), meaning, rangeText(range));
  }
  void operator()(const char* name, Vec3d& value, Range range, const char* meaning) {
    line(name, vectorText(value), meaning, rangeText(range));
  }
  void operator()(const char* name, Mat3<double>& value, Range range, const char* meaning) {
    const std::string rows = vectorText(value.row(0)) + ", " + vectorText(value.row(1)) + ", " +
                             vectorText(value.row(2));
    line(name, "[" + rows + "]", meaning, rangeText(range));
  }
  void operator()(const char* name, bool& value, const char* meaning) {
    line(name, value ? "true" : "false", meaning, "true, false");
  }
  void operator()(const char* name, std::string& value, const char* meaning) {
    line(name, "\"" + value + "\"", meaning, "text");
  }
  template <class Choice>
  std::enable_if_t<std::is_enum_v<Choice>> operator()(const char* name, Choice& value,
                                                      const char* meaning) {
    const std::vector<std::string> names = choices(value);
    line(name, names[static_cast<std::size_t>(value)], meaning, joined(names));
  }

  template <class Params>
  void section(const char* name, Params& params, const char* meaning) {
    out_ << "\n# " << meaning << "\n" << indent_ << name << ":\n";
    describe(params, Writer(out_, indent_ + "  "));
  }

  template <class Item>
  void list(const char* name, std::vector<Item>&, const char* meaning) {
    out_ << "\n# " << meaning << ": a list, empty by default. One entry with its defaults:\n"
         << indent_ << name << ": []\n";
    Item item;
    out_ << "#  -\n";
    describe(item, Writer(out_, "#    "));
  }

 private:
  static std::string vectorText(const Vec3d& value) {
    return "[" + numberText(value.x()) + ", " + numberText(value.y()) + ", " +
           numberText(value.z()) + "]";
  }

  static std::string rangeText(Range range) {
    return "[" + numberText(range.min) + ", " + numberText(range.max) + "]";
  }

  void line(const char* name, const std::string& value, const char* meaning,
            const std::string& allowed) {
    const std::string key = indent_ + name + ": " + value;
    const std::size_t column = 44;
    out_ << key << std::string(key.size() < column ? column - key.size() : 1, ' ') << "# "
         << meaning << "  {" << allowed << "}\n";
  }

  std::ostream& out_;
  std::string indent_;
};

}  // namespace

std::string defaultYaml() {
  std::ostringstream out;
  out << "# Every key of a scene file, with its default, meaning and {allowed values}.\n"
         "# To make a scene, copy a file of config/scenes, edit it and run it: run_scene "
         "my_scene.yaml\n"
         "# Units are SI, z is up, temperatures are degrees Celsius.\n"
         "# Written by run_scene --defaults; a test compares this file with the code.\n\n";
  Scene scene;
  describe(scene, Writer(out, ""));
  return out.str();
}

}  // namespace ice_ice_baby
