// Names of topics of one node.
#pragma once

#include <string>

namespace ice_ice_baby {

/// The topic of the same node with another last name: for "/left/ice_ice_baby/surface" and "state"
/// it is "/left/ice_ice_baby/state".
inline std::string topicBeside(const std::string& topic, const std::string& name) {
  return topic.substr(0, topic.rfind('/') + 1) + name;
}

}  // namespace ice_ice_baby
