#include "ice_ice_baby/errors.h"
#include "robot_links.h"

namespace ice_ice_baby {

void addRobotLinks(Scene&, const std::string&, const std::vector<std::string>&) {
  throw InvalidInput(
      "parameter ~links needs liburdf-dev, without which this program was built; install it and "
      "build again, or leave ~links empty");
}

}  // namespace ice_ice_baby
