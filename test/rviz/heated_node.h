// A node that only tells of a scene with heat and hears what the panel asks of it.
#pragma once

#include <ice_ice_baby/GetState.h>
#include <ice_ice_baby/SetTemperature.h>
#include <ice_ice_baby/State.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <mutex>

namespace ice_ice_baby {

class HeatedNode {
 public:
  HeatedNode() {
    node_.setCallbackQueue(&queue_);
    state_.thermal = true;
    state_.targets = {"container", "plate"};
    state_.temperature = 20.0;
    state_.mean_temperature = 3.5;
    state_.strictness = 0.25;
    state_.particles = 100;
    state_.steam_particles = 7;
    servers_[0] = node_.advertiseService("get_state", &HeatedNode::getState, this);
    servers_[1] = node_.advertiseService("set_temperature", &HeatedNode::setTemperature, this);
    spinner_.start();
  }

  SetTemperature::Request asked() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return asked_;
  }

 private:
  bool getState(GetState::Request&, GetState::Response& response) {
    response.success = true;
    response.state = state_;
    return true;
  }

  bool setTemperature(SetTemperature::Request& request, SetTemperature::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked_ = request;
    response.success = true;
    return true;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle node_{"/heated"};
  State state_;
  std::mutex mutex_;  ///< guards asked_
  SetTemperature::Request asked_;
  ros::ServiceServer servers_[2];
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace ice_ice_baby
