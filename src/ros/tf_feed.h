// Fills a tf buffer, message by message.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

#include <functional>

#include "own_frames.h"
#include "tf_watch.h"

namespace ice_ice_baby {

/// Like tf2_ros::TransformListener, with a call after each message. Frames of this node are left
/// out: whoever sends them puts them into the buffer itself.
class TfFeed {
 public:
  /// `buffer`, `own` and `watch` must outlive this object. @param arrived called on a thread of
  /// this object
  TfFeed(const ros::NodeHandle& node, tf2_ros::Buffer& buffer, const OwnFrames& own, TfWatch& watch,
         std::function<void()> arrived);

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  void takeDynamic(const Event& event) { take(event, false); }
  void takeStatic(const Event& event) { take(event, true); }
  void take(const Event& event, bool is_static);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  tf2_ros::Buffer& buffer_;
  const OwnFrames& own_;
  TfWatch& watch_;
  const std::function<void()> arrived_;
  ros::Time latest_;
  ros::Subscriber dynamic_;
  ros::Subscriber static_;
  ros::AsyncSpinner spinner_;
};

}  // namespace ice_ice_baby
