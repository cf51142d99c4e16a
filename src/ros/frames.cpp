#include "frames.h"

#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>
#include <tf2_msgs/TFMessage.h>

#include "geometry.h"
#include "ice_ice_baby/each_collider.h"

namespace ice_ice_baby {

namespace {

geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child,
                                          const Posed& pose, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform = transformMessage(pose);
  return message;
}

bool same(const Posed& a, const Posed& b) {
  return a.position == b.position && a.rotation == b.rotation;
}

}  // namespace

Frames::Frames(ros::NodeHandle& node, const NodeParameters& parameters, const Scene& scene)
    : parent_(parameters.frame_id),
      scene_frame_(parameters.scene_frame),
      scene_pose_(poseOf(parameters.scene_position_m, parameters.scene_rpy_deg)),
      dynamic_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 100, true)) {
  buffer_.setUsingDedicatedThread(true);
  prepare(scene);
}

void Frames::prepare(const Scene& scene) {
  bool follows = false;
  forEachCollider(scene, [&](const Collider& collider) {
    follows = follows || !collider.follow_frame.empty();
  });
  if (!follows) {
    listener_.reset();
  } else if (!listener_) {
    listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_);
  }
}

void Frames::sceneStarted(const Simulation& simulation, const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform(parent_, scene_frame_, scene_pose_, stamp));
  buffer_.setTransform(message.transforms.back(), "self", true);
  followers_.clear();
  setLost({});
  forEachCollider(simulation.scene(), [&](const Collider& collider) {
    const Posed pose = simulation.colliderPose(collider.name);
    if (collider.follow_frame.empty()) {
      message.transforms.push_back(transform(scene_frame_, frameOf(collider.name), pose, stamp));
    } else {
      followers_.push_back({collider.name, collider.follow_frame, collider.pose(), pose});
    }
  });
  static_.publish(message);
}

void Frames::moveFollowers(Simulation& simulation) {
  if (followers_.empty()) return;
  std::vector<std::string> lost;
  for (const Follower& follower : followers_) {
    try {
      const auto found = buffer_.lookupTransform(scene_frame_, follower.frame, ros::Time(0));
      const Posed frame = poseOf(found.transform);
      simulation.moveCollider(follower.name, {frame.toWorld(follower.offset.position),
                                              frame.rotation * follower.offset.rotation});
    } catch (const std::exception& e) {
      lost.push_back(follower.name + " stands still: " + e.what());
      ROS_WARN_THROTTLE(10.0, "Collider %s follows tf frame %s and stands still: %s",
                        follower.name.c_str(), follower.frame.c_str(), e.what());
    }
  }
  setLost(std::move(lost));
}

bool Frames::publishFollowers(const Simulation& simulation, const ros::Time& stamp) {
  if (followers_.empty()) return false;
  bool moved = false;
  tf2_msgs::TFMessage message;
  for (Follower& follower : followers_) {
    const Posed pose = simulation.colliderPose(follower.name);
    moved = moved || !same(pose, follower.published);
    follower.published = pose;
    message.transforms.push_back(transform(scene_frame_, frameOf(follower.name), pose, stamp));
  }
  if (dynamic_.getNumSubscribers() > 0) dynamic_.publish(message);
  return moved;
}

std::vector<std::string> Frames::lost() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lost_;
}

void Frames::setLost(std::vector<std::string> lost) {
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ = std::move(lost);
}

}  // namespace ice_ice_baby
