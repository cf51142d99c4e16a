#include "handles.h"

#include <ros/console.h>

#include <cmath>

#include "geometry.h"

namespace ice_ice_baby {

namespace {

/// Poses closer than this, in m and of rotations, are the same.
constexpr double kThere = 1e-6;

bool near(const Posed& a, const Posed& b) {
  return (a.position - b.position).norm() < kThere && a.rotation.isApprox(b.rotation, kThere);
}

bool usable(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  const double length = Eigen::Quaterniond(q.w, q.x, q.y, q.z).norm();
  const Vec3d position = vectorOf(pose.position);
  return position.allFinite() && position.cwiseAbs().maxCoeff() <= kMaxCoordinate_m &&
         std::abs(length - 1.0) < 0.01;
}

}  // namespace

Handles::Handles(const ros::NodeHandle& node_private, const NodeParameters& parameters)
    : scene_frame_(parameters.scene_frame), bounds_(motionBounds(parameters)) {
  if (!parameters.handles) return;
  server_ =
      makeMarkerServer(node_private.resolveName("handles"),
                       [this](const std::string& marker, const geometry_msgs::PoseStamped& pose) {
                         drag(marker, pose);
                       });
}

void Handles::sceneStarted(const Simulation& simulation) {
  if (!server_) return;
  parts_.clear();
  colliders_.clear();
  std::vector<visualization_msgs::InteractiveMarker> markers;
  for (const Handle& handle : everyHandle(simulation.scene(), scene_frame_)) {
    parts_.push_back({handle.what, std::nullopt});
    if (handle.what.kind == SteeredKind::kCollider) colliders_.push_back(handle.what.name);
    markers.push_back(handle.marker);
    markers.back().pose = poseMessage(poseNow(simulation, handle.what));
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dragged_.clear();
  }
  server_->show(markers);
}

void Handles::drag(const std::string& marker, const geometry_msgs::PoseStamped& pose) {
  if (pose.header.frame_id != scene_frame_ || !usable(pose.pose)) {
    ROS_WARN(
        "The marker of %s goes back: its pose has to be in the frame %s, at most %g m from the "
        "origin along each axis, with a unit quaternion",
        marker.c_str(), scene_frame_.c_str(), kMaxCoordinate_m);
    const std::lock_guard<std::mutex> lock(mutex_);
    dragged_[marker].reset();
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  dragged_[marker] = poseOf(pose.pose);
}

void Handles::move(Simulation& simulation) {
  if (!server_) return;
  std::map<std::string, std::optional<Posed>> dragged;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dragged.swap(dragged_);
  }
  for (Part& part : parts_) {
    const auto found = dragged.find(part.what.words());
    if (found != dragged.end() && found->second) begin(simulation, part, *found->second);
    if (found != dragged.end() && !found->second) putBack(simulation, part);
    if (part.way) moveOne(simulation, part);
  }
}

void Handles::begin(const Simulation& simulation, Part& part, const Posed& end) const {
  if (!part.way) {
    part.way.emplace(Way{end, MotionLimit(bounds_)});
    part.way->limit.start(poseNow(simulation, part.what));
  }
  part.way->end = end;
}

void Handles::putBack(const Simulation& simulation, Part& part) {
  server_->put(part.what.words(), poseMessage(poseNow(simulation, part.what)));
  part.way.reset();
}

void Handles::moveOne(Simulation& simulation, Part& part) {
  const Posed now = poseNow(simulation, part.what);
  const double frame_s = 1.0 / simulation.scene().solver.frame_rate_hz;
  const MotionLimit::Step step = part.way->limit.step(part.way->end, frame_s);
  try {
    moveSteered(simulation, part.what, step.pose);
  } catch (const std::exception& e) {
    ROS_WARN("The marker of %s goes back: %s", part.what.words().c_str(), e.what());
    return putBack(simulation, part);
  }
  if (near(now, part.way->end) && near(step.pose, part.way->end)) part.way.reset();
}

}  // namespace ice_ice_baby
