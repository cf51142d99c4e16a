// The panel's talk with a simulation node: service calls and state, off the GUI thread. Knows no
// Qt.
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

/// What became of one service call.
struct Answer {
  std::string service;   ///< private name, as "set_temperature"
  bool reached = false;  ///< false: no node offers the service or it went away during the call
  bool success = false;  ///< what the node answered
  std::string message;   ///< the node's own words or why it could not be asked
};

/// Calls the services of one node in the order asked and follows its state. Every function returns
/// at once; what comes back is handed to Callbacks on threads of this object, never the caller's.
class SimulationClient {
 public:
  struct Callbacks {
    std::function<void(const Answer&)> answered;
    std::function<void(const State&)> state;
    std::function<void(const std::vector<std::string>&)> scenes;  ///< names that reset accepts
  };

  /// Needs ros::init before. Talks to nobody until follow().
  explicit SimulationClient(Callbacks callbacks);

  /// Breaks off a call under way; no callback comes after it.
  ~SimulationClient();

  SimulationClient(const SimulationClient&) = delete;
  SimulationClient& operator=(const SimulationClient&) = delete;

  /// Talks to `node`, as "/ice_ice_baby", from now on and forgets calls not yet made.
  /// @return false, and nothing changes, if that is no valid ROS name
  bool follow(const std::string& node);

  /// Resolved name of the node followed.
  const std::string& node() const { return node_; }

  /// @param target "": the scene, with heat its air; with heat also the name of a collider
  void setTemperature(double celsius, double ramp_s, const std::string& target = "");
  void pause();
  void resume();
  void step(unsigned frames);

  /// @param scene "": the one that runs  @param preset "default", "paper" or "": as the scene has
  /// it
  void reset(const std::string& scene, const std::string& preset);

  /// Asks for state and scenes; they come by their own callbacks, and an answer as well.
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
  ros::ServiceClient under_way_;  ///< held so that it can be broken off from outside
  unsigned generation_ = 0;       ///< counts follow(): an older call's answer is dropped
  bool stopping_ = false;

  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  ros::Subscriber state_subscriber_;
  ros::AsyncSpinner spinner_;
  std::thread worker_;
};

}  // namespace ice_ice_baby
