#include "tf_watch.h"

#include <ros/console.h>

#include <cmath>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Deviation of a rotation's squared length from 1 that tf2::BufferCore::setTransform accepts.
constexpr double kUnitTolerance = 1e-2;
constexpr std::size_t kMaxFrames = 20;

}  // namespace

std::string refusalOf(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  if (!std::isfinite(t.x) || !std::isfinite(t.y) || !std::isfinite(t.z)) {
    return "its translation is not finite";
  }
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!std::isfinite(length)) return "its rotation is not finite";
  if (std::abs(length * length - 1.0) < kUnitTolerance) return "";
  return "the length of its rotation is " + numberText(length) + " and must be 1";
}

std::vector<std::string> TfWatch::refused() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> lines;
  for (const auto& [frame, why] : refused_) {
    lines.emplace_back("tf frame ");
    lines.back().append(frame).append(" cannot be used: ").append(why);
  }
  return lines;
}

void TfWatch::see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& stamped : event.getConstMessage()->transforms) {
    const std::string frame = shortened(stamped.child_frame_id);
    const std::string why = refusalOf(stamped.transform);
    if (why.empty()) {
      refused_.erase(frame);
    } else if (refused_.size() < kMaxFrames && refused_.count(frame) == 0) {
      refused_[frame] = why + "; sent by " + event.getPublisherName();
      ROS_WARN("tf frame %s cannot be used: %s", frame.c_str(), refused_[frame].c_str());
    }
  }
}

}  // namespace ice_ice_baby
