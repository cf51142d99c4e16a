#include "wrench_topics.h"

#include <geometry_msgs/WrenchStamped.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <utility>

#include "ice_ice_baby/each_collider.h"
#include "topic_name.h"

namespace ice_ice_baby {

namespace {

/// Messages that wait for a slow subscriber before the oldest is dropped.
constexpr std::uint32_t kQueue = 2;

void set(const Vec3d& from, geometry_msgs::Vector3& to) {
  to.x = from.x();
  to.y = from.y();
  to.z = from.z();
}

}  // namespace

WrenchTopics::WrenchTopics(const ros::NodeHandle& node, std::string scene_frame, double rate_hz)
    : node_(node), scene_frame_(std::move(scene_frame)), rate_hz_(rate_hz), gate_(rate_hz) {}

void WrenchTopics::sceneStarted(const Simulation& simulation) {
  std::vector<ros::Publisher> publishers;
  forEachCollider(simulation.scene(), [&](const Collider& collider) {
    publishers.push_back(node_.advertise<geometry_msgs::WrenchStamped>(
        "wrenches/" + topicNameOf(collider.name), kQueue));
  });
  publishers_ = std::move(publishers);  // a topic of the same name has never been away
  measuring_ = false;
}

bool WrenchTopics::anySubscribed() const {
  return rate_hz_ > 0 && std::any_of(publishers_.begin(), publishers_.end(), [](const auto& topic) {
           return topic.getNumSubscribers() > 0;
         });
}

void WrenchTopics::frameBegins(Simulation& simulation) {
  const bool wanted = anySubscribed();
  if (wanted != measuring_ || (wanted && sent_)) simulation.measureWrenches(wanted);
  measuring_ = wanted;
  sent_ = false;
}

bool WrenchTopics::publish(const Simulation& simulation, const ros::Time& stamp, bool news,
                           bool last) {
  if (!measuring_ || !news || sent_ || !gate_.pass(WallClock::now(), last)) return false;
  const std::vector<ColliderWrench> wrenches = simulation.wrenches();
  for (std::size_t k = 0; k < std::min(wrenches.size(), publishers_.size()); ++k) {
    if (publishers_[k].getNumSubscribers() == 0) continue;
    const auto message = boost::make_shared<geometry_msgs::WrenchStamped>();
    message->header.stamp = stamp;
    message->header.frame_id = scene_frame_ + "/" + wrenches[k].name;
    set(wrenches[k].force_n, message->wrench.force);
    set(wrenches[k].torque_n_m, message->wrench.torque);
    publishers_[k].publish(message);
  }
  sent_ = true;
  return true;
}

}  // namespace ice_ice_baby
