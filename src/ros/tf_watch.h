// Finds invalid transforms, so that diagnostics can say why a collider does not move.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/message_event.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// Why a transform is invalid: not finite, or a rotation not of unit length. "" for a valid one.
std::string refusalOf(const geometry_msgs::Transform& transform);

/// Looks at transforms beside tf2, which drops invalid ones without a message on /rosout. Each
/// frame is logged once, when it becomes invalid. Thread safe.
class TfWatch {
 public:
  /// @param event a message on /tf or /tf_static
  void see(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);

  /// One line per frame whose latest transform is invalid, at most 20.
  std::vector<std::string> refused() const;

 private:
  mutable std::mutex mutex_;                    ///< guards refused_
  std::map<std::string, std::string> refused_;  ///< why, by frame
};

}  // namespace ice_ice_baby
