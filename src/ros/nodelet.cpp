// The node as a nodelet: other nodelets of its manager receive messages without a copy.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "simulation_node.h"

namespace ice_ice_baby {

class SimulationNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      node_ = std::make_unique<SimulationNode>(getMTNodeHandle(), getMTPrivateNodeHandle());
    } catch (const std::exception& e) {
      NODELET_FATAL("%s", e.what());
      throw;
    }
  }

  std::unique_ptr<SimulationNode> node_;
};

}  // namespace ice_ice_baby

PLUGINLIB_EXPORT_CLASS(ice_ice_baby::SimulationNodelet, nodelet::Nodelet)
