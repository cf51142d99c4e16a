#include "loading/yaml_text.h"

#include <yaml-cpp/eventhandler.h>

#include <map>
#include <sstream>
#include <vector>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Handles the events of the parser, before any tree is built.
class Guard : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(mark, anchor, "~"); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    leaf(mark, anchor, value);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto meant = sizes_.find(anchor);
    if (meant == sizes_.end()) {
      throw InvalidInput("the alias in line " + lineText(mark) + " lies within what it stands for");
    }
    place(mark, nullptr);
    count(meant->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor, false);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor, true);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    bool map;
    YAML::anchor_t anchor;
    std::size_t entries_before;
    bool key_next;  ///< in a map: whether a key comes next, or a value
    std::map<std::string, int> lines;
  };

  static std::string lineText(const YAML::Mark& mark) { return std::to_string(mark.line + 1); }

  void leaf(const YAML::Mark& mark, YAML::anchor_t anchor, const std::string& value) {
    place(mark, &value);
    count(1);
    if (anchor != YAML::NullAnchor) sizes_[anchor] = 1;
  }

  void open(const YAML::Mark& mark, YAML::anchor_t anchor, bool map) {
    place(mark, nullptr);
    if (open_.size() == kMaxYamlDepth) {
      throw InvalidInput("line " + lineText(mark) + " is nested deeper than " +
                         std::to_string(kMaxYamlDepth) + " levels, which no key of a scene needs");
    }
    open_.push_back({map, anchor, entries_, map, {}});
    count(1);
  }

  void close() {
    const Open& done = open_.back();
    if (done.anchor != YAML::NullAnchor) sizes_[done.anchor] = entries_ - done.entries_before;
    open_.pop_back();
  }

  /// Counts a key or value of the open map or list; `text` if it is a scalar.
  void place(const YAML::Mark& mark, const std::string* text) {
    if (open_.empty() || !open_.back().map) return;
    Open& map = open_.back();
    const bool key = map.key_next;
    map.key_next = !key;
    if (!key || !text) return;
    const auto [first, fresh] = map.lines.emplace(*text, mark.line + 1);
    if (fresh) return;
    throw InvalidInput("key " + shortened(*text) + " stands twice, in line " +
                       std::to_string(first->second) + " and in line " + lineText(mark) +
                       "; remove one of them");
  }

  void count(std::size_t more) {
    entries_ += more;
    if (entries_ <= kMaxYamlEntries) return;
    throw InvalidInput("more than " + std::to_string(kMaxYamlEntries) +
                       " entries, each alias counted as all that it stands for");
  }

  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> sizes_;  ///< entries behind each anchor
  std::size_t entries_ = 0;
};

void requireWellFormed(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Guard guard;
  if (!parser.HandleNextDocument(guard)) return;
  if (parser.HandleNextDocument(guard)) {
    throw InvalidInput("more than one YAML document; a scene is one, so remove the lines ---");
  }
}

}  // namespace

YAML::Node parseYaml(const std::string& text, const std::string& origin) {
  if (text.size() > kMaxYaml_bytes) {
    throw InvalidInput(origin + ": " + std::to_string(text.size()) + " bytes, more than " +
                       std::to_string(kMaxYaml_bytes));
  }
  try {
    requireWellFormed(text);
    return YAML::Load(text);
  } catch (const YAML::Exception& e) {
    throw InvalidInput(origin + ": not valid YAML: " + shortened(e.what()));
  } catch (const InvalidInput& e) {
    throw InvalidInput(origin + ": " + e.what());
  }
}

}  // namespace ice_ice_baby
