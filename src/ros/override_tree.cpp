#include "override_tree.h"

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

using XmlRpc::XmlRpcValue;

/// Control characters become escapes such as \x0a; YAML would fold or drop raw ones.
std::string quoted(const std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      out += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + "\"";
}

std::string listText(const XmlRpcValue& list, const std::string& key) {
  std::string out = "[";
  for (int k = 0; k < list.size(); ++k) {
    out += (k ? ", " : "") + yamlText(list[k], key + "." + std::to_string(k));
  }
  return out + "]";
}

std::string mapText(const XmlRpcValue& map, const std::string& key) {
  std::string out = "{";
  for (auto entry = map.begin(); entry != map.end(); ++entry) {
    out += (entry == map.begin() ? "" : ", ") + quoted(entry->first) + ": " +
           yamlText(entry->second, key + "." + entry->first);
  }
  return out + "}";
}

/// Far above any scene written by hand.
constexpr std::size_t kMaxText = 1000000;

std::size_t textOf(const std::vector<Override>& overrides) {
  std::size_t total = 0;
  for (const Override& change : overrides) total += change.key.size() + change.value.size();
  return total;
}

void collect(const XmlRpcValue& tree, const std::string& path, std::vector<Override>& out) {
  for (auto entry = tree.begin(); entry != tree.end(); ++entry) {
    const std::string key = path.empty() ? entry->first : path + "." + entry->first;
    if (entry->second.getType() == XmlRpcValue::TypeStruct) {
      collect(entry->second, key, out);
    } else {
      out.push_back({key, yamlText(entry->second, key)});
    }
  }
}

}  // namespace

std::string yamlText(const XmlRpcValue& value, const std::string& key) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<const bool&>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<const int&>(value));
    case XmlRpcValue::TypeDouble:
      return numberText(static_cast<const double&>(value));
    case XmlRpcValue::TypeString:
      return quoted(static_cast<const std::string&>(value));
    case XmlRpcValue::TypeArray:
      return listText(value, key);
    case XmlRpcValue::TypeStruct:
      return mapText(value, key);
    default:
      throw InvalidInput("parameter " + shortened(key) +
                         " must be a number, a text, true, false, a list or a map of them");
  }
}

std::vector<Override> readOverrides(const XmlRpcValue& tree) {
  std::vector<Override> overrides;
  if (tree.getType() != XmlRpcValue::TypeStruct) {
    throw InvalidInput("parameter ~overrides = " + shortened(yamlText(tree, "~overrides")) +
                       " must be a map of scene keys, as {fluid: {spacing_m: 0.04}}");
  }
  collect(tree, "", overrides);
  if (textOf(overrides) > kMaxText) {
    throw InvalidInput("parameter ~overrides holds " + std::to_string(textOf(overrides)) +
                       " characters, outside the allowed range [0, " + std::to_string(kMaxText) +
                       "]; put the scene in a .yaml file and name it in ~scene");
  }
  return overrides;
}

}  // namespace ice_ice_baby
