#include "solid_topics.h"

#include <ice_ice_baby/FloatingSolids.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <utility>

#include "geometry.h"
#include "markers.h"

namespace ice_ice_baby {

namespace {

/// Messages that wait for a slow subscriber before the oldest is dropped.
constexpr std::uint32_t kQueue = 2;

}  // namespace

SolidTopics::SolidTopics(const ros::NodeHandle& node, std::string scene_frame, double rate_hz)
    : node_(node), scene_frame_(std::move(scene_frame)), rate_hz_(rate_hz), gate_(rate_hz) {}

void SolidTopics::sceneStarted(const Simulation& simulation) {
  if (simulation.scene().solids.empty()) {
    states_.shutdown();
    markers_.shutdown();
    return;
  }
  states_ = node_.advertise<FloatingSolids>("solids", kQueue);
  markers_ = node_.advertise<visualization_msgs::MarkerArray>("solid_markers", kQueue);
  std_msgs::Header header;
  header.frame_id = scene_frame_;
  shapes_ = solidMarkers(simulation.scene(), header);
  listeners_ = 0;
}

/// Whether there is a new frame and it is time for it, or a subscriber is new.
bool SolidTopics::due(const Simulation& simulation, bool last) {
  const std::uint32_t listeners = states_.getNumSubscribers() + markers_.getNumSubscribers();
  const bool joined = listeners > std::exchange(listeners_, listeners);
  if (rate_hz_ == 0.0 || listeners == 0) return false;
  const bool news = simulation.report().frame != frame_;
  return joined || (news && gate_.pass(WallClock::now(), last));
}

void SolidTopics::publish(const Simulation& simulation, const ros::Time& stamp, bool last) {
  if (!states_ || !due(simulation, last)) return;
  frame_ = simulation.report().frame;
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = scene_frame_;
  const std::vector<SolidState> states = simulation.solids();
  if (states_.getNumSubscribers() > 0) publishStates(states, simulation.report().time_s, header);
  if (markers_.getNumSubscribers() > 0) publishMarkers(states, header);
}

void SolidTopics::publishStates(const std::vector<SolidState>& states, double time_s,
                                const std_msgs::Header& header) {
  const auto message = boost::make_shared<FloatingSolids>();
  message->header = header;
  message->time_s = time_s;
  for (const SolidState& state : states) {
    auto& solid = message->solids.emplace_back();
    solid.name = state.name;
    solid.pose = poseMessage(state.pose);
    solid.twist.linear = vectorMessage(state.velocity_m_s);
    solid.twist.angular = vectorMessage(state.angular_velocity_rad_s);
    solid.asleep = state.asleep;
    solid.held = state.held;
  }
  states_.publish(message);
}

/// A solid that has left the scene is deleted.
void SolidTopics::publishMarkers(const std::vector<SolidState>& states,
                                 const std_msgs::Header& header) {
  const auto message = boost::make_shared<visualization_msgs::MarkerArray>(shapes_);
  for (auto& marker : message->markers) {
    const auto found = std::find_if(states.begin(), states.end(), [&](const SolidState& state) {
      return state.name == marker.ns;
    });
    marker.header = header;
    if (found == states.end()) {
      marker.action = visualization_msgs::Marker::DELETE;
    } else {
      marker.pose = poseMessage(found->pose);
    }
  }
  markers_.publish(message);
}

}  // namespace ice_ice_baby
