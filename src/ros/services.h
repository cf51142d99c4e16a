// The services, except save, load and load_scene. Each checks its request, queues a command and
// answers without waiting for the solver.
#pragma once

#include <ice_ice_baby/Attach.h>
#include <ice_ice_baby/GetState.h>
#include <ice_ice_baby/HeatRegion.h>
#include <ice_ice_baby/Reset.h>
#include <ice_ice_baby/SetGravity.h>
#include <ice_ice_baby/SetHeatRegion.h>
#include <ice_ice_baby/SetSource.h>
#include <ice_ice_baby/SetTemperature.h>
#include <ice_ice_baby/Step.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <mutex>
#include <string>
#include <vector>

#include "clock_publisher.h"
#include "parameters.h"
#include "simulation_thread.h"
#include "topics.h"

namespace ice_ice_baby {

class Services {
 public:
  /// @param node of the private names; its queue may be served by several threads
  Services(ros::NodeHandle& node, const NodeParameters& parameters, SimulationThread& simulation,
           const Topics& topics, const ClockPublisher& clock);

  /// Full names of all services.
  std::vector<std::string> names() const;

 private:
  bool setTemperature(SetTemperature::Request& request, SetTemperature::Response& response);
  bool heatRegion(HeatRegion::Request& request, HeatRegion::Response& response);
  bool setGravity(SetGravity::Request& request, SetGravity::Response& response);
  bool setHeatRegion(SetHeatRegion::Request& request, SetHeatRegion::Response& response);
  bool setSource(SetSource::Request& request, SetSource::Response& response);
  bool attach(Attach::Request& request, Attach::Response& response);
  bool reset(Reset::Request& request, Reset::Response& response);
  bool step(Step::Request& request, Step::Response& response);
  bool pause(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool getState(GetState::Request& request, GetState::Response& response);
  /// The scene that a reset asks for. @throws InvalidInput for an unknown scene or preset
  ServedScene sceneFor(const Reset::Request& request) const;

  const NodeParameters parameters_;
  SimulationThread& simulation_;
  const Topics& topics_;
  const ClockPublisher& clock_;
  std::mutex reset_mutex_;  ///< one reset at a time
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace ice_ice_baby
