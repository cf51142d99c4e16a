#include "topics.h"

#include <boost/make_shared.hpp>

#include "ice_ice_baby/each_collider.h"
#include "markers.h"
#include "state_message.h"
#include "vessels_message.h"

namespace ice_ice_baby {

Topics::Topics(ros::NodeHandle& node, const NodeParameters& parameters)
    : node_(node),
      scene_frame_(parameters.scene_frame),
      rgb_(parameters.particles_rgb),
      stride_(static_cast<std::size_t>(parameters.particles_stride)),
      springs_max_(static_cast<std::size_t>(parameters.springs_max)),
      particles_(parameters.particles_rate_hz),
      springs_(parameters.springs_rate_hz),
      colliders_(30.0),
      state_(parameters.state_rate_hz),
      vessels_(parameters.vessels_rate_hz),
      wrenches_(node, parameters.scene_frame, parameters.wrenches_rate_hz),
      solids_(node, parameters.scene_frame, parameters.solids_rate_hz),
      publisher_({[this] { publishParticles(); }, [this] { publishSprings(); },
                  [this] { publishColliders(); }, [this] { publishState(); },
                  [this] { publishVessels(); }}) {
  particles_.advertise<sensor_msgs::PointCloud2>(node, "particles");
  springs_.advertise<visualization_msgs::MarkerArray>(node, "springs");
  colliders_.advertise<visualization_msgs::MarkerArray>(node, "colliders", true);
  state_.advertise<State>(node, "state");
  vessels_.advertise<ice_ice_baby::Vessels>(node, "vessels");
}

void Topics::sceneStarted(const Simulation& simulation) {
  particle_news_.add(false);
  spring_news_.add(false);
  state_news_.add(false);
  vessel_news_.add(false);
  collider_news_ = {};
  scene_started_ = true;
  wrenches_.sceneStarted(simulation);
  solids_.sceneStarted(simulation);
  scene_ = std::make_shared<const Scene>(simulation.scene());
  startCameras();
}

void Topics::startCameras() {
  if (!cameras_ && scene_->cameras.empty()) return;
  if (!cameras_) cameras_ = std::make_unique<CameraTopics>(node_, scene_frame_);
  cameras_->sceneStarted(scene_);
}

void Topics::frameBegins(Simulation& simulation) {
  simulation.countFlows(vessels_.subscribed());
  wrenches_.frameBegins(simulation);
}

void Topics::publish(const Simulation& simulation, const Snapshot& snapshot, const ros::Time& stamp,
                     bool colliders_moved, bool settled) {
  addNews(snapshot, colliders_moved, settled);
  // Busy topics are not asked whether they are due: the answer would count as sent.
  const auto due = [this](Topic topic, RatedTopic& rated, const News& news, bool repeat) {
    return !publisher_.busy(topic) && rated.due(news.any, news.last, repeat);
  };
  if (due(kParticles, particles_, particle_news_, true)) takeParticles(simulation, stamp);
  const bool springs = snapshot.report.springs > 0 || taken_springs_ > 0;
  if (due(kSprings, springs_, springs ? spring_news_ : News(), springs)) {
    takeSprings(simulation, stamp);
  }
  const bool start = scene_started_ && !publisher_.busy(kColliders);
  if (start || (collider_news_.any && due(kColliders, colliders_, collider_news_, false))) {
    takeColliders(simulation, stamp);
  }
  if (due(kState, state_, state_news_, true)) {
    state_news_ = {};
    state_snapshot_.stamp = stamp;
    state_snapshot_.snapshot = snapshot;
    publisher_.request(kState);
  }
  if (due(kVessels, vessels_, vessel_news_, true)) takeVessels(simulation, stamp);
  solids_.publish(simulation, stamp, settled);
  if (cameras_) cameras_->publish(simulation, stamp, settled);
  if (wrenches_.publish(simulation, stamp, wrench_news_.any, wrench_news_.last)) wrench_news_ = {};
}

void Topics::addNews(const Snapshot& snapshot, bool colliders_moved, bool settled) {
  if (colliders_moved) collider_news_.add(settled);
  if (snapshot.report.frame == frame_ && settled == settled_) return;
  frame_ = snapshot.report.frame;
  settled_ = settled;
  for (News* news : {&particle_news_, &spring_news_, &state_news_, &vessel_news_, &wrench_news_}) {
    news->add(settled);
  }
}

void Topics::takeParticles(const Simulation& simulation, const ros::Time& stamp) {
  particle_news_ = {};
  const Colouring coloured =
      simulation.scene().thermal.enabled ? Colouring::kHeat : Colouring::kScene;
  particle_snapshot_.stamp = stamp;
  particle_snapshot_.colouring = rgb_ ? coloured : Colouring::kPlain;
  simulation.sample(particle_snapshot_.samples, stride_);
  publisher_.request(kParticles);
}

void Topics::takeSprings(const Simulation& simulation, const ros::Time& stamp) {
  spring_news_ = {};
  std::vector<SpringSample>& samples = spring_snapshot_.samples;
  simulation.sampleSprings(samples, springs_max_);
  spring_snapshot_.stamp = stamp;
  spring_snapshot_.width_m = 0.08 * simulation.scene().fluid.spacing_m;
  spring_snapshot_.clear = samples.size() < taken_springs_ || samples.empty();
  taken_springs_ = samples.size();
  publisher_.request(kSprings);
}

void Topics::takeColliders(const Simulation& simulation, const ros::Time& stamp) {
  collider_news_ = {};
  scene_started_ = false;
  collider_snapshot_.stamp = stamp;
  collider_snapshot_.scene = scene_;
  collider_snapshot_.poses.clear();
  forEachCollider(*scene_, [&](const Collider& collider) {
    collider_snapshot_.poses.push_back(simulation.colliderPose(collider.name));
  });
  publisher_.request(kColliders);
}

void Topics::takeVessels(const Simulation& simulation, const ros::Time& stamp) {
  vessel_news_ = {};
  vessel_snapshot_.stamp = stamp;
  vessel_snapshot_.time_s = simulation.report().time_s;
  vessel_snapshot_.spilled = simulation.report().spilled;
  vessel_snapshot_.vessels = simulation.vessels();
  publisher_.request(kVessels);
}

void Topics::publishParticles() {
  // The memory of the last message serves again unless a subscriber in this process holds it.
  if (!cloud_.unique()) cloud_ = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud_->header = header(particle_snapshot_.stamp);
  writeCloud(particle_snapshot_.samples, particle_snapshot_.colouring, *cloud_);
  particles_.publish(cloud_);
}

void Topics::publishSprings() {
  springs_.publish(boost::make_shared<visualization_msgs::MarkerArray>(
      springMarkers(spring_snapshot_.samples, header(spring_snapshot_.stamp),
                    spring_snapshot_.width_m, spring_snapshot_.clear)));
}

void Topics::publishColliders() {
  colliders_.publish(boost::make_shared<visualization_msgs::MarkerArray>(colliderMarkers(
      *collider_snapshot_.scene, collider_snapshot_.poses, header(collider_snapshot_.stamp))));
}

void Topics::publishState() {
  const auto state = boost::make_shared<State>(
      stateMessage(state_snapshot_.snapshot, header(state_snapshot_.stamp)));
  state->topics = loads();
  state_.publish(state);
}

void Topics::publishVessels() {
  const auto message = boost::make_shared<ice_ice_baby::Vessels>(
      vesselsMessage(vessel_snapshot_.vessels, header(vessel_snapshot_.stamp)));
  message->time_s = vessel_snapshot_.time_s;
  message->spilled = vessel_snapshot_.spilled;
  vessels_.publish(message);
}

std::vector<TopicLoad> Topics::loads() const {
  return {particles_.load(), springs_.load(), colliders_.load(), state_.load(), vessels_.load()};
}

std_msgs::Header Topics::header(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = scene_frame_;
  return header;
}

}  // namespace ice_ice_baby
