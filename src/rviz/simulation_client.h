// Connection of the panel to a simulation node: service calls and state, off the GUI thread,
// without Qt.
#pragma once

#include <ice_ice_baby/State.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_client.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ice_ice_baby {

/// Result of a service call.
struct Answer {
  std::string service;   ///< private name, such as "set_temperature"
  bool reached = false;  ///< false: no node offers the service or it went away during the call
  bool success = false;  ///< answer of the node
  std::string message;   ///< message of the node, or why it could not be called
};

/// Calls the services of one node in the order requested and follows its state. Every function
/// returns at once; results are passed to Callbacks on threads of this object, never the caller's.
class SimulationClient {
 public:
  struct Callbacks {
    std::function<void(const Answer&)> answered;
    std::function<void(const State&)> state;
    std::function<void(const std::vector<std::string>&)> scenes;  ///< names that reset accepts
  };

  /// Requires ros::init. Connects to no node until follow().
  explicit SimulationClient(Callbacks callbacks);

  /// Cancels a pending call. No callback runs after the destructor.
  ~SimulationClient();

  SimulationClient(const SimulationClient&) = delete;
  SimulationClient& operator=(const SimulationClient&) = delete;

  /// Connects to `node`, such as "/ice_ice_baby", and discards calls not yet made.
  /// @return false, without any change, if that is not a valid ROS name
  bool follow(const std::string& node);

  /// Resolved name of the node.
  const std::string& node() const { return node_; }

  /// @param target "": the scene, with heat its air; with heat also the name of a collider
  void setTemperature(double celsius, double ramp_s, const std::string& target = "");
  void pause();
  void resume();
  void step(unsigned frames);

  /// @param scene "": the one that runs  @param preset "default", "paper" or "": as the scene has
  /// it
  void reset(const std::string& scene, const std::string& preset);

  /// Requests state and scenes; each arrives by its own callback, and so does the answer.
  void refresh();

 private:
  using Job = std::function<Answer(const std::string& node)>;

  void enqueue(Job job);
  void work();
  void breakOff();

  template <typename Service>
  Answer call(const std::string& node, const std::string& name, Service& service);

  Callbacks callbacks_;
  std::string node_;  ///< the caller's thread only

  std::mutex mutex_;  ///< guards what follows
  std::condition_variable wake_;
  std::deque<std::function<Answer()>> jobs_;
  ros::ServiceClient under_way_;  ///< a member, so that another thread can cancel it
  unsigned generation_ = 0;       ///< number of follow() calls; answers of older ones are dropped
  bool stopping_ = false;

  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  ros::Subscriber state_subscriber_;
  ros::AsyncSpinner spinner_;
  std::thread worker_;
};

}  // namespace ice_ice_baby
