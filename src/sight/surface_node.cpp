#include "surface_node.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloud_samples.h"
#include "ice_ice_baby/errors.h"
#include "surface_message.h"

namespace ice_ice_baby {

namespace {

constexpr double kRate_hz = 30.0, kMaxRate_hz = 1000.0;

double rateOf(const ros::NodeHandle& node_private) {
  const double rate_hz = node_private.param("rate_hz", kRate_hz);
  if (rate_hz > 0.0 && rate_hz <= kMaxRate_hz) return rate_hz;
  throw InvalidInput("the parameter rate_hz is " + numberText(rate_hz) +
                     "; it may be above 0 and at most " + numberText(kMaxRate_hz));
}

/// Whether a state is of the scene of a cloud, and the cloud has all particles: those that are left
/// out leave holes. Sources and drains change the number between the two.
bool belong(const sensor_msgs::PointCloud2& cloud, const State& state) {
  const double particles = state.particles;
  return std::abs(cloud.width - particles) <= std::max(500.0, particles / 3);
}

}  // namespace

SurfaceNode::SurfaceNode(const ros::NodeHandle& node, const ros::NodeHandle& node_private)
    : simulation_(node, node_private.param<std::string>("simulation", "ice_ice_baby")),
      gate_(rateOf(node_private)),
      spinner_(1, &queue_) {
  if (!makesSurfaces()) {
    throw InvalidInput(
        "surfaces need OpenVDB, which this program was built without; install libopenvdb-dev and "
        "build it again");
  }
  simulation_.setCallbackQueue(&queue_);
  const auto changed = [this](const ros::SingleSubscriberPublisher&) { followSubscribers(); };
  surface_ = simulation_.advertise<Surface>("surface", 1, changed, changed);
  markers_ = simulation_.advertise<visualization_msgs::MarkerArray>("surface_markers", 1, changed,
                                                                    changed);
  spinner_.start();
}

void SurfaceNode::followSubscribers() {
  const bool wanted = surface_.getNumSubscribers() + markers_.getNumSubscribers() > 0;
  if (wanted && !particles_) {
    states_ = simulation_.subscribe("state", 1, &SurfaceNode::takeState, this);
    particles_ = simulation_.subscribe("particles", 1, &SurfaceNode::takeParticles, this);
  }
  if (!wanted && particles_) {
    particles_.shutdown();
    states_.shutdown();
    particles_ = states_ = ros::Subscriber();
    state_ = nullptr;
    waiting_ = nullptr;
  }
}

void SurfaceNode::takeState(const State::ConstPtr& state) {
  state_ = state;
  publish();
}

void SurfaceNode::takeParticles(const sensor_msgs::PointCloud2::ConstPtr& cloud) {
  if (!gate_.pass(WallClock::now(), false)) return;
  waiting_ = cloud;
  publish();
}

void SurfaceNode::publish() {
  if (!state_ || !waiting_) return;
  const bool together = belong(*waiting_, *state_);
  // The next state may be that of a scene that has just been loaded.
  if (!together && state_->header.stamp <= waiting_->header.stamp) return;
  const auto cloud = std::exchange(waiting_, nullptr);
  if (!together) {
    ROS_WARN_THROTTLE(10.0, "No surface: %s has %u of %u particles; set particles_stride to 1",
                      particles_.getTopic().c_str(), cloud->width, state_->particles);
    return;
  }
  try {
    if (!(state_->spacing_m > 0.0)) throw InvalidInput("the state has no spacing_m");
    const auto message =
        boost::make_shared<Surface>(surfaceMessage(readSamples(*cloud), state_->spacing_m));
    message->header = cloud->header;
    message->thermal = state_->thermal;
    if (surface_.getNumSubscribers() > 0) surface_.publish(message);
    if (markers_.getNumSubscribers() > 0) markers_.publish(surfaceMarkers(*message));
  } catch (const std::exception& e) {  // also of OpenVDB, or out of memory
    ROS_ERROR_THROTTLE(10.0, "No surface: %s", e.what());
  }
}

}  // namespace ice_ice_baby
