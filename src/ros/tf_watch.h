// Finds invalid transforms, so that diagnostics can say why a collider does not move.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// Why a transform is invalid: not finite, or a rotation not of unit length. "" for a valid one.
std::string refusalOf(const geometry_msgs::Transform& transform);

/// Listens to /tf and /tf_static beside tf2, which drops invalid transforms without a message on
/// /rosout. Each frame is logged once, when it becomes invalid.
class TfWatch {
 public:
  explicit TfWatch(ros::NodeHandle& node);

  /// One line per frame whose latest transform is invalid, at most 20.
  std::vector<std::string> refused() const;

 private:
  void see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);

  mutable std::mutex mutex_;                    ///< guards refused_
  std::map<std::string, std::string> refused_;  ///< why, by frame
  ros::Subscriber dynamic_;
  ros::Subscriber static_;
};

}  // namespace ice_ice_baby
