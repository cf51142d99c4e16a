#include "frames.h"

#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

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

}  // namespace

Frames::Frames(ros::NodeHandle& node, const NodeParameters& parameters)
    : parent_(parameters.frame_id),
      scene_frame_(parameters.scene_frame),
      scene_pose_(poseOf(parameters.scene_position_m, parameters.scene_rpy_deg)),
      dynamic_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 100, true)),
      listening_(node, buffer_) {
  buffer_.setUsingDedicatedThread(true);
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
  listening_.want(!followers_.empty());
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
      const Vec3d from = simulation.colliderPose(follower.name).position;
      const Vec3d to = frame.toWorld(follower.offset.position);
      simulation.moveCollider(follower.name, {to, frame.rotation * follower.offset.rotation});
      noteJump(follower, simulation.scene(), from, to);
    } catch (const std::exception& e) {
      lost.push_back("collider " + follower.name + ", which follows tf frame " + follower.frame +
                     ", does not move: " + e.what());
    }
  }
  setLost(std::move(lost));
}

/// tf2 clears its buffer at the jump, but an old transform that arrives afterwards would make it
/// reject all newer ones. So the buffer is cleared again once late transforms have arrived.
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
  std::vector<std::string> lines = listening_.refused();
  const std::lock_guard<std::mutex> lock(mutex_);
  lines.insert(lines.end(), lost_.begin(), lost_.end());
  return lines;
}

Frames::Jumps Frames::jumps() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return jumps_;
}

void Frames::noteJump(const Follower& follower, const Scene& scene, const Vec3d& from,
                      const Vec3d& to) {
  const double max_m = scene.solver.max_speed_m_s / scene.solver.frame_rate_hz;
  const double distance_m = (to - from).norm();
  if (distance_m <= max_m) return;
  const std::string to_mm = numberText(std::round(1e3 * distance_m) / 1e3);
  const std::lock_guard<std::mutex> lock(mutex_);
  jumps_.count += 1;
  jumps_.latest = "collider " + follower.name + " jumped " + to_mm + " m with tf frame " +
                  follower.frame + " and took its contents along, because it moved more than the " +
                  numberText(max_m) + " m per frame that solver.max_speed_m_s allows";
}

void Frames::setLost(std::vector<std::string> lost) {
  // Not throttled: a throttled log is silent until a simulated clock ticks.
  if (lost.size() > lost_.size()) ROS_WARN("%s", joined(lost).c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ = std::move(lost);
}

}  // namespace ice_ice_baby
