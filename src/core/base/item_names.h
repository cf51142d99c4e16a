// Names of the items of a list of the scene, in messages and as they have to be.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

/// "sources.0 (tap)"
template <class Item>
std::string wordsFor(const char* list, std::size_t k, const Item& item) {
  const std::string key = list + ("." + std::to_string(k));
  return item.name.empty() ? key : key + " (" + shortened(item.name) + ")";
}

/// @throws InvalidInput for a name that is not fit for a tf frame, and for one that occurs twice
template <class Item>
void requireNames(const std::vector<Item>& items, const std::string& noun) {
  std::set<std::string> taken;
  for (const Item& item : items) {
    if (item.name.empty()) continue;  // allowed in scenes built in code
    requireFrameName("name of a " + noun, item.name);
    if (taken.insert(item.name).second) continue;
    throw InvalidInput("two " + noun + "s are called " + item.name + "; give each its own name");
  }
}

/// @throws InvalidInput for a `follow_frame` that is not fit for a tf frame
template <class Item>
void requireFollowFrame(const Item& item, const std::string& noun) {
  if (item.follow_frame.empty()) return;
  requireFrameName("follow_frame of " + noun + " " + item.name, item.follow_frame);
}

}  // namespace ice_ice_baby
