// Parses YAML text with limits on size and nesting, which yaml-cpp does not have.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace ice_ice_baby {

/// Limits on text length, nesting depth and number of entries. An alias counts as its whole
/// content.
constexpr std::size_t kMaxYaml_bytes = 1 << 20;
constexpr std::size_t kMaxYamlDepth = 20;
constexpr std::size_t kMaxYamlEntries = 1000000;

/// @throws InvalidInput naming `origin` for invalid YAML, more than one document, text beyond the
/// limits, and a key that occurs twice in a map (yaml-cpp would silently take the first)
YAML::Node parseYaml(const std::string& text, const std::string& origin);

}  // namespace ice_ice_baby
