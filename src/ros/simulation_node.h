// The node: everything between the simulation and ROS, as a process or a nodelet.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include "checkpoints.h"
#include "clock_publisher.h"
#include "diagnostics.h"
#include "frames.h"
#include "handles.h"
#include "master_watch.h"
#include "parameters.h"
#include "scene_loading.h"
#include "services.h"
#include "simulation_thread.h"
#include "topics.h"

namespace ice_ice_baby {

class SimulationNode {
 public:
  /// Reads the private parameters, builds the scene and serves it.
  /// @throws InvalidInput with the parameter or key, the value and what is allowed
  SimulationNode(const ros::NodeHandle& node, const ros::NodeHandle& node_private);

  /// Ends the simulation after the frame under way. @returns whether it ended within `patience_s`
  bool stop(double patience_s) { return simulation_.stop(patience_s); }

 private:
  RunOptions runOptions() const;
  RunHooks hooks();
  std::vector<std::string> serviceNames() const;

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_;
  const NodeParameters parameters_;
  const CheckpointFolder folder_;
  Resumption resumed_;
  const ServedScene scene_;
  ClockPublisher clock_;
  Frames frames_;
  Handles handles_;
  Topics topics_;
  SimulationThread simulation_;
  Services services_;
  Checkpoints checkpoints_;
  SceneLoading scene_loading_;
  Diagnostics diagnostics_;
  ros::AsyncSpinner spinner_;
  MasterWatch watch_;
};

}  // namespace ice_ice_baby
