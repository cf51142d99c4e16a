// Finds other nodes that send the frames of this one, so that diagnostics can name them.
#pragma once

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <mutex>
#include <string>

#include "own_frames.h"

namespace ice_ice_baby {

/// Listens to /tf_static, where every node sends the frame of its scene.
class FrameClash {
 public:
  /// @param own must outlive this object
  FrameClash(ros::NodeHandle& node, const OwnFrames& own);

  /// One frame, the node that sends it too and what to do; "" if there is none.
  std::string clash() const;

 private:
  void see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);

  const OwnFrames& own_;
  mutable std::mutex mutex_;                   ///< guards others_
  std::map<std::string, std::string> others_;  ///< a frame of this node, by the other node
  ros::Subscriber static_;
};

}  // namespace ice_ice_baby
