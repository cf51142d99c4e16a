// Conversion between vectors and poses of the core and messages.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>

#include <cmath>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

inline geometry_msgs::Quaternion quaternionMessage(const Mat3<double>& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

inline geometry_msgs::Point pointMessage(const Vec3d& point) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = point.z();
  return message;
}

inline geometry_msgs::Vector3 vectorMessage(const Vec3d& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

inline Vec3d vectorOf(const geometry_msgs::Vector3& message) {
  return {message.x, message.y, message.z};
}

inline Vec3d vectorOf(const geometry_msgs::Point& message) {
  return {message.x, message.y, message.z};
}

inline geometry_msgs::Pose poseMessage(const Posed& pose) {
  geometry_msgs::Pose message;
  message.position = pointMessage(pose.position);
  message.orientation = quaternionMessage(pose.rotation);
  return message;
}

inline geometry_msgs::Transform transformMessage(const Posed& pose) {
  geometry_msgs::Transform message;
  message.translation = vectorMessage(pose.position);
  message.rotation = quaternionMessage(pose.rotation);
  return message;
}

inline Mat3<double> rotationOf(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

inline Posed poseOf(const geometry_msgs::Transform& message) {
  return {vectorOf(message.translation), rotationOf(message.rotation)};
}

inline Posed poseOf(const geometry_msgs::Pose& message) {
  return {vectorOf(message.position), rotationOf(message.orientation)};
}

}  // namespace ice_ice_baby
