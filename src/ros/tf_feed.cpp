#include "tf_feed.h"

#include <ros/console.h>

#include <utility>

namespace ice_ice_baby {

namespace {

ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

TfFeed::TfFeed(const ros::NodeHandle& node, tf2_ros::Buffer& buffer, const OwnFrames& own,
               TfWatch& watch, std::function<void()> arrived)
    : node_(onQueue(node, queue_)),
      buffer_(buffer),
      own_(own),
      watch_(watch),
      arrived_(std::move(arrived)),
      dynamic_(node_.subscribe("/tf", 100, &TfFeed::takeDynamic, this)),
      static_(node_.subscribe("/tf_static", 100, &TfFeed::takeStatic, this)),
      spinner_(1, &queue_) {
  spinner_.start();
}

void TfFeed::take(const Event& event, bool is_static) {
  const ros::Time now = ros::Time::now();
  if (now < latest_) {
    ROS_WARN("ROS time jumped back; all transforms from before are dropped");
    buffer_.clear();
  }
  latest_ = now;
  watch_.see(event);
  const std::string sender = event.getPublisherName();
  for (const auto& transform : event.getConstMessage()->transforms) {
    if (own_.has(transform.child_frame_id)) continue;
    try {
      buffer_.setTransform(transform, sender, is_static);
    } catch (const tf2::TransformException& e) {
      ROS_ERROR("tf from %s: %s", sender.c_str(), e.what());
    }
  }
  arrived_();
}

}  // namespace ice_ice_baby
