#include "frames.h"

#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>
#include <tf2_msgs/TFMessage.h>

#include "geometry.h"
#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

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

bool hasFollower(const Scene& scene) {
  bool follows = false;
  forEachCollider(scene, [&](const Collider& collider) {
    follows = follows || !collider.follow_frame.empty();
  });
  return follows;
}

}  // namespace

Frames::Frames(ros::NodeHandle& node, const NodeParameters& parameters, const Scene& scene)
    : parent_(parameters.frame_id),
      scene_frame_(parameters.scene_frame),
      scene_pose_(poseOf(parameters.scene_position_m, parameters.scene_rpy_deg)),
      dynamic_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 100, true)),
      node_(node) {
  buffer_.setUsingDedicatedThread(true);
  listenFor(scene);
}

void Frames::listenFor(const Scene& scene) {
  const std::lock_guard<std::mutex> lock(listener_mutex_);
  if (hasFollower(scene) && !listener_) listener_ = std::make_unique<Listener>(node_, buffer_);
}

void Frames::listenLess(const Scene& coming) {
  const std::lock_guard<std::mutex> lock(listener_mutex_);
  if (!follows_ && !hasFollower(coming)) listener_.reset();
}

void Frames::sceneStarted(const Simulation& simulation, const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform(parent_, scene_frame_, scene_pose_, stamp));
  buffer_.setTransform(message.transforms.back(), "self", true);
  followers_.clear();
  forEachCollider(simulation.scene(), [&](const Collider& collider) {
    const Posed pose = simulation.colliderPose(collider.name);
    if (collider.follow_frame.empty()) {
      message.transforms.push_back(transform(scene_frame_, frameOf(collider.name), pose, stamp));
    } else {
      followers_.push_back({collider.name, collider.follow_frame, collider.pose(), pose});
    }
  });
  static_.publish(message);
  follows_ = !followers_.empty();
  setLost({});
}

void Frames::moveFollowers(Simulation& simulation) {
  if (followers_.empty()) return;
  clearAfterJump();
  std::vector<std::string> lost;
  for (const Follower& follower : followers_) {
    try {
      const auto found = buffer_.lookupTransform(scene_frame_, follower.frame, ros::Time(0));
      const Posed frame = poseOf(found.transform);
      simulation.moveCollider(follower.name, {frame.toWorld(follower.offset.position),
                                              frame.rotation * follower.offset.rotation});
    } catch (const std::exception& e) {
      lost.push_back("collider " + follower.name + ", which follows tf frame " + follower.frame +
                     ", stands still: " + e.what());
    }
  }
  setLost(std::move(lost));
}

/// tf2 does so at once, but a transform from before the jump that comes after it would then keep
/// out all newer ones as old; so once more when those on their way have arrived.
void Frames::clearAfterJump() {
  const ros::Time now = ros::Time::now();
  if (now < latest_) clear_at_ = ros::WallTime::now() + ros::WallDuration(0.5);
  latest_ = now;
  if (clear_at_.isZero() || ros::WallTime::now() < clear_at_) return;
  clear_at_ = ros::WallTime();
  buffer_.clear();
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
  std::vector<std::string> lines;
  {
    // Whoever holds it may wait for the master, which diagnostics must not.
    const std::unique_lock<std::mutex> lock(listener_mutex_, std::try_to_lock);
    if (lock && listener_) lines = listener_->watch.refused();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  lines.insert(lines.end(), lost_.begin(), lost_.end());
  return lines;
}

void Frames::setLost(std::vector<std::string> lost) {
  // A throttled log would say nothing before the first tick of a simulated clock.
  if (lost.size() > lost_.size()) ROS_WARN("%s", joined(lost).c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ = std::move(lost);
}

}  // namespace ice_ice_baby
