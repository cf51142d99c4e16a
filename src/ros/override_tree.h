// A tree of the parameter server as overrides of scene keys.
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {

/// Each leaf of `tree` with its dotted key: {fluid: {spacing_m: 0.04}} is fluid.spacing_m = 0.04.
/// A list is one value, as spheres: [{radius_m: 0.1}].
/// @throws InvalidInput where the tree is not a map or holds a date or binary data
std::vector<Override> readOverrides(const XmlRpc::XmlRpcValue& tree);

/// A value as YAML on one line. @param key names it in messages @throws InvalidInput as above
std::string yamlText(const XmlRpc::XmlRpcValue& value, const std::string& key);

}  // namespace ice_ice_baby
