#include "ice_ice_baby/errors.h"
#include "marker_server.h"

namespace ice_ice_baby {

std::unique_ptr<MarkerServer> makeMarkerServer(
    const std::string&,
    std::function<void(const std::string&, const geometry_msgs::PoseStamped&)>) {
  throw InvalidInput(
      "parameter ~handles needs libinteractive-markers-dev, without which this program was built; "
      "install it and build again, or set ~handles to false");
}

}  // namespace ice_ice_baby
