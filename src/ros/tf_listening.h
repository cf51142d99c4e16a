// The subscriptions to tf, which come and go with the colliders that need them.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ice_ice_baby {

/// Fills a buffer from /tf and /tf_static while that is wanted. To subscribe waits for the master,
/// however long it is dead, so a thread of its own does so and nobody else waits.
class TfListening {
 public:
  /// @param buffer has to live longer
  TfListening(const ros::NodeHandle& node, tf2_ros::Buffer& buffer);
  ~TfListening();

  /// Begins or ends soon, or when the master is there again; answers at once.
  void want(bool wanted);

  /// One line per frame whose latest transform tf refuses, none while it does not listen.
  std::vector<std::string> refused() const;

 private:
  struct Listener;

  void run();

  ros::NodeHandle node_;
  tf2_ros::Buffer& buffer_;
  mutable std::mutex mutex_;  ///< guards the next four
  std::condition_variable changed_;
  bool wanted_ = false;
  bool stopping_ = false;
  std::unique_ptr<Listener> listener_;
  std::thread thread_;
};

}  // namespace ice_ice_baby
