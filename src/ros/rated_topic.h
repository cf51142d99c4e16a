// A topic with a maximum rate, which counts its messages.
#pragma once

#include <ice_ice_baby/TopicLoad.h>
#include <ros/node_handle.h>

#include <atomic>
#include <string>

#include "pacing.h"

namespace ice_ice_baby {

/// One thread asks when a message is due, another may publish it.
class RatedTopic {
 public:
  explicit RatedTopic(double rate_hz) : gate_(rate_hz) {}

  template <class Message>
  void advertise(ros::NodeHandle& node, const std::string& name, bool latch = false);

  bool subscribed() const { return publisher_.getNumSubscribers() > 0; }

  /// Whether to build a message: there is a subscriber, and either there is news and the rate
  /// allows it, or the subscriber is new, or the last message is a second old.
  /// @param news since the last message
  /// @param last whether no more news follows for a while, so that this one must go out
  /// @param repeat whether a message that is a second old is repeated without news
  bool due(bool news, bool last, bool repeat = true);

  /// Subscribers in this process get `message` itself, without a copy, so it must not change while
  /// anyone else holds it.
  template <class Message>
  void publish(const boost::shared_ptr<Message>& message);

  TopicLoad load() const;

 private:
  /// Messages that wait for a slow subscriber before the oldest is dropped.
  static constexpr std::uint32_t kQueue = 2;

  ros::Publisher publisher_;
  RateGate gate_;
  std::atomic<bool> new_subscriber_{false};
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> bytes_{0};
};

template <class Message>
void RatedTopic::advertise(ros::NodeHandle& node, const std::string& name, bool latch) {
  publisher_ = node.advertise<Message>(
      name, kQueue, [this](const ros::SingleSubscriberPublisher&) { new_subscriber_ = true; },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), latch);
}

template <class Message>
void RatedTopic::publish(const boost::shared_ptr<Message>& message) {
  messages_ += 1;
  bytes_ += ros::serialization::serializationLength(*message);
  publisher_.publish(message);
}

}  // namespace ice_ice_baby
