// YAML text as a tree, under limits that yaml-cpp itself does not have.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace ice_ice_baby {

/// Longest text, deepest nesting and most entries, each alias counted as all that it stands for.
constexpr std::size_t kMaxYaml_bytes = 1 << 20;
constexpr std::size_t kMaxYamlDepth = 20;
constexpr std::size_t kMaxYamlEntries = 1000000;

/// @throws InvalidInput naming `origin` for what is not YAML, is more than one document or beyond
/// the limits, and for a key that stands twice in one map, of which yaml-cpp would take the first
YAML::Node parseYaml(const std::string& text, const std::string& origin);

}  // namespace ice_ice_baby
