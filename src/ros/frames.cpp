#include "frames.h"

#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <set>

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

Frames::Frames(ros::NodeHandle& node, const NodeParameters& parameters)
    : parent_(parameters.frame_id),
      scene_frame_(parameters.scene_frame),
      scene_pose_(poseOf(parameters.scene_position_m, parameters.scene_rpy_deg)),
      dynamic_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 100, true)),
      clash_(node, own_),
      followers_(node, parameters, own_) {}

void Frames::sceneStarted(const Simulation& simulation, const ros::Time& stamp,
                          const std::vector<std::string>& dragged) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform(parent_, scene_frame_, scene_pose_, stamp));
  std::set<std::string> own{scene_frame_};
  forEachCollider(simulation.scene(), [&](const Collider& collider) {
    own.insert(frameOf(collider.name));
    const bool moves = !collider.follow_frame.empty() ||
                       std::count(dragged.begin(), dragged.end(), collider.name) > 0;
    if (moves) return;
    const Posed pose = simulation.colliderPose(collider.name);
    message.transforms.push_back(transform(scene_frame_, frameOf(collider.name), pose, stamp));
  });
  for (const Camera& camera : simulation.scene().cameras) {
    if (!camera.follow_frame.empty()) continue;
    own.insert(frameOf(camera.name));
    message.transforms.push_back(
        transform(scene_frame_, frameOf(camera.name), camera.pose(), stamp));
  }
  for (const Solid& solid : simulation.scene().solids) own.insert(frameOf(solid.name));
  own_.set(std::move(own));
  for (const auto& fixed : message.transforms) followers_.addOwn(fixed, true);
  static_.publish(message);
  followers_.sceneStarted(simulation);
  moving_ = followers_.colliders();
  moving_.insert(moving_.end(), dragged.begin(), dragged.end());
  published_.clear();
  for (const std::string& name : moving_) {
    published_.push_back(simulation.colliderPose(name));
  }
}

void Frames::publishSolids(const Simulation& simulation, const ros::Time& stamp) {
  if (simulation.scene().solids.empty() || stamp == solid_stamp_) return;
  if (dynamic_.getNumSubscribers() == 0) return;
  solid_stamp_ = stamp;
  tf2_msgs::TFMessage message;
  for (const SolidState& state : simulation.solids()) {
    message.transforms.push_back(transform(scene_frame_, frameOf(state.name), state.pose, stamp));
  }
  dynamic_.publish(message);
}

bool Frames::publishFollowers(const Simulation& simulation, const ros::Time& stamp) {
  if (published_.empty()) return false;
  bool moved = false;
  tf2_msgs::TFMessage message;
  for (std::size_t k = 0; k < published_.size(); ++k) {
    const std::string& name = moving_[k];
    const Posed pose = simulation.colliderPose(name);
    moved = moved || !same(pose, published_[k]);
    published_[k] = pose;
    message.transforms.push_back(transform(scene_frame_, frameOf(name), pose, stamp));
  }
  // tf2 warns about a second transform of a stamp and drops it.
  if (stamp == stamp_) return moved;
  stamp_ = stamp;
  for (const auto& transform : message.transforms) followers_.addOwn(transform, false);
  if (dynamic_.getNumSubscribers() > 0) dynamic_.publish(message);
  return moved;
}

}  // namespace ice_ice_baby
