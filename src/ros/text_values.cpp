#include "text_values.h"

#include <cstdlib>
#include <sstream>

namespace ice_ice_baby {

std::optional<double> numberIn(const std::string& text) {
  // Not nan, inf and hexadecimal numbers, which strtod reads too.
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) return {};
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size()) return {};
  return value;
}

std::optional<Vec3d> vectorIn(const std::string& text) {
  std::string bare;
  for (const char c : text) {
    if (c != ' ') bare += c;
  }
  if (bare.size() < 2 || bare.front() != '[' || bare.back() != ']') return {};
  std::istringstream parts(bare.substr(1, bare.size() - 2) + ",");
  Vec3d vector;
  Eigen::Index count = 0;
  for (std::string part; std::getline(parts, part, ','); ++count) {
    const std::optional<double> value = numberIn(part);
    if (!value || count == 3) return {};
    vector[count] = *value;
  }
  if (count != 3) return {};
  return vector;
}

}  // namespace ice_ice_baby
