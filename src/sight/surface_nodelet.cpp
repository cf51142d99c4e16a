// The surface of the water in the process of a nodelet manager.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "surface_node.h"

namespace ice_ice_baby {

class SurfaceNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      node_ = std::make_unique<SurfaceNode>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& e) {
      NODELET_FATAL("%s", e.what());
      throw;
    }
  }

  std::unique_ptr<SurfaceNode> node_;
};

}  // namespace ice_ice_baby

PLUGINLIB_EXPORT_CLASS(ice_ice_baby::SurfaceNodelet, nodelet::Nodelet)
