// Names of topics of the parts of a scene.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace ice_ice_baby {

/// The name of a part in that of a topic: what a ROS name may not contain becomes an underscore.
inline std::string topicNameOf(std::string part) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '/'; };
  std::replace_if(
      part.begin(), part.end(), [&](unsigned char c) { return !allowed(c); }, '_');
  return part;
}

}  // namespace ice_ice_baby
