// Transforms that nobody can use, so that a collider which stands still says why.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// Why a transform cannot be used: a part that is not finite, or a rotation that is not of unit
/// length. "" where it can.
std::string refusalOf(const geometry_msgs::Transform& transform);

/// Listens to /tf and /tf_static beside tf2, which drops such transforms with no word on /rosout.
/// Each frame is logged when it goes bad, not at every message.
class TfWatch {
 public:
  explicit TfWatch(ros::NodeHandle& node);

  /// One line per frame whose latest transform cannot be used, 20 at most.
  std::vector<std::string> refused() const;

 private:
  void see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);

  mutable std::mutex mutex_;                    ///< guards refused_
  std::map<std::string, std::string> refused_;  ///< why, by frame
  ros::Subscriber dynamic_;
  ros::Subscriber static_;
};

}  // namespace ice_ice_baby
