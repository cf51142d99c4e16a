// The service load_scene: another scene, by its name or as text.
#pragma once

#include <ice_ice_baby/LoadScene.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <string>

#include "parameters.h"
#include "simulation_thread.h"

namespace ice_ice_baby {

/// Builds the whole simulation before it answers, so that everything about the scene that can be
/// refused is refused with its reason, while the running one goes on. A thread of this class does
/// that, so neither frames nor other services wait.
class SceneLoading {
 public:
  /// @param node with the private names
  SceneLoading(ros::NodeHandle node, const NodeParameters& parameters,
               SimulationThread& simulation);

  /// Full name of the service.
  std::string name() const { return server_.getService(); }

 private:
  bool loadScene(LoadScene::Request& request, LoadScene::Response& response);
  ServedScene sceneFor(const LoadScene::Request& request) const;

  const NodeParameters parameters_;
  SimulationThread& simulation_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace ice_ice_baby
