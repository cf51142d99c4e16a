#include <sstream>

#include "robot_links.h"

namespace ice_ice_baby {

std::vector<std::string> linkPatterns(const std::string& links) {
  std::string spaced = links;
  for (char& c : spaced) {
    if (c == ',') c = ' ';
  }
  std::istringstream words(spaced);
  std::vector<std::string> patterns;
  for (std::string word; words >> word;) patterns.push_back(word);
  return patterns;
}

}  // namespace ice_ice_baby
