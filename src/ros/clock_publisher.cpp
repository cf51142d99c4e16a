#include "clock_publisher.h"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr const char* kClock = "/clock";
constexpr std::chrono::milliseconds kRepeat{40};

/// Name of a node other than this one that publishes /clock, or "".
std::string otherClock() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, payload, false)) return "";
  XmlRpc::XmlRpcValue& publishers = payload[0];
  for (int k = 0; k < publishers.size(); ++k) {
    if (std::string(publishers[k][0]) != kClock) continue;
    for (int n = 0; n < publishers[k][1].size(); ++n) {
      std::string name = publishers[k][1][n];
      if (name != ros::this_node::getName()) return name;
    }
  }
  return "";
}

ros::Time wallNow() {
  const ros::WallTime now = ros::WallTime::now();
  return ros::Time(now.sec, now.nsec);
}

}  // namespace

ClockPublisher::ClockPublisher(ros::NodeHandle& node, bool wanted)
    : wanted_(wanted), start_(wallNow()), now_(start_) {
  if (!wanted_) return;
  checkConflict();
  if (!conflict_.empty()) return;
  publisher_ = node.advertise<rosgraph_msgs::Clock>(kClock, 10);
  if (!ros::Time::isSimTime()) {
    ROS_WARN(
        "~publish_clock is true, but /use_sim_time was not when the node started, so messages "
        "carry the machine's time. Set /use_sim_time before starting any node.");
  }
}

/// With the mutex held.
bool ClockPublisher::simulates() const {
  return wanted_ && ros::Time::isSimTime() && conflict_.empty();
}

ros::Time ClockPublisher::stamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return simulates() ? now_ : ros::Time::now();
}

ros::Time ClockPublisher::frameStamp(const FrameBegin& frame, bool announced) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (simulates()) {
      const ros::Time end = start_ + ros::Duration(frame.end_s);
      if (announced && end > now_) {
        now_ = end;
        publish(true);
      }
      return end;
    }
  }
  const ros::Time now = ros::Time::now();
  // Differences of ros::Time throw beyond 68 years.
  if (origin_.isZero() || std::abs(double(now.sec) - double(origin_.sec)) > 1e9) {
    origin_ = now;
    stamps_.restart();
  }
  if (frame.stepped) {
    stamps_.restart();
    return now;
  }
  const ros::Time stamp =
      origin_ + ros::Duration(stamps_.next((now - origin_).toSec() - frame.late_s));
  // A robot in simulated time has sent nothing for times to come.
  return ros::Time::isSimTime() ? std::min(stamp, now) : stamp;
}

void ClockPublisher::tick(double simulated_s) {
  if (!wanted_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  // A frame that was announced and failed does not turn the clock back.
  now_ = std::max(now_, start_ + ros::Duration(simulated_s));
  publish(false);
}

void ClockPublisher::publish(bool urgent) {
  const WallClock::time_point now = WallClock::now();
  // A time that stands still is repeated for nodes that come later, but not right away.
  if (now_ == published_ && now - gate_.latest() < kRepeat) return;
  if (!publisher_ || !gate_.pass(now, urgent)) return;
  published_ = now_;
  rosgraph_msgs::Clock message;
  message.clock = now_;
  publisher_.publish(message);
}

void ClockPublisher::checkConflict() {
  if (!wanted_ || !conflict().empty()) return;
  const std::string other = otherClock();
  if (other.empty()) return;
  ROS_ERROR(
      "~publish_clock is true, but %s publishes /clock already, so this node does not. Stop "
      "that node and restart this one.",
      other.c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  conflict_ = other;
  publisher_.shutdown();
}

std::string ClockPublisher::conflict() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return conflict_;
}

}  // namespace ice_ice_baby
