#include "frame_clash.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

constexpr std::size_t kMaxNodes = 20;

std::string messageOf(const std::string& frame, const std::string& node) {
  return "tf frame " + frame + " is sent by " + node +
         " too, so data may appear at the wrong place; give each node a ~scene_frame of its own";
}

}  // namespace

FrameClash::FrameClash(ros::NodeHandle& node, const OwnFrames& own)
    : own_(own), static_(node.subscribe("/tf_static", 100, &FrameClash::see, this)) {}

std::string FrameClash::clash() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  // Where only this node is left to publish, the other one has ended.
  if (others_.empty() || static_.getNumPublishers() < 2) return "";
  return messageOf(others_.begin()->second, others_.begin()->first);
}

void FrameClash::see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
  const std::string node = event.getPublisherName();
  if (node == ros::this_node::getName()) return;
  for (const auto& stamped : event.getConstMessage()->transforms) {
    const std::string& frame = stamped.child_frame_id;
    if (!own_.has(frame)) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (others_.size() >= kMaxNodes || !others_.emplace(node, frame).second) continue;
    ROS_WARN("%s", messageOf(frame, node).c_str());
  }
}

}  // namespace ice_ice_baby
