// Reads overrides of scene keys from a tree of the parameter server.
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {

/// Each leaf of `tree` with its dotted key: {fluid: {spacing_m: 0.04}} is fluid.spacing_m = 0.04.
/// A list is one value, for example spheres: [{radius_m: 0.1}].
/// @throws InvalidInput for a tree that is not a map, holds a date or binary data, or is too long
std::vector<Override> readOverrides(const XmlRpc::XmlRpcValue& tree);

/// A value as YAML on one line. @param key its name in error messages @throws InvalidInput for a
/// date or binary data
std::string yamlText(const XmlRpc::XmlRpcValue& value, const std::string& key);

}  // namespace ice_ice_baby
