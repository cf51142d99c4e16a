// Subscriptions to tf, only while some collider needs them.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "own_frames.h"

namespace ice_ice_baby {

/// Fills a buffer from /tf and /tf_static while wanted. Subscribing blocks while the master is
/// down, so a separate thread does it.
class TfListening {
 public:
  /// @param buffer, own must outlive this object @param own frames that are left out
  /// @param arrived called after each message, on a thread of its own
  TfListening(const ros::NodeHandle& node, tf2_ros::Buffer& buffer, const OwnFrames& own,
              std::function<void()> arrived);
  ~TfListening();

  /// Starts or stops listening soon, or when the master answers again. Returns at once.
  void want(bool wanted);

  /// One line per frame whose latest transform tf rejects; none while not listening.
  std::vector<std::string> refused() const;

 private:
  struct Listener;

  void run();

  ros::NodeHandle node_;
  tf2_ros::Buffer& buffer_;
  const OwnFrames& own_;
  const std::function<void()> arrived_;
  mutable std::mutex mutex_;  ///< guards the next four
  std::condition_variable changed_;
  bool wanted_ = false;
  bool stopping_ = false;
  std::unique_ptr<Listener> listener_;
  std::thread thread_;
};

}  // namespace ice_ice_baby
