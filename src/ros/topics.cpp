#include "topics.h"

#include <ice_ice_baby/State.h>

#include "markers.h"
#include "particle_cloud.h"
#include "state_message.h"

namespace ice_ice_baby {

namespace {

/// Messages that wait for a slow subscriber before the oldest is dropped.
constexpr std::uint32_t kQueue = 2;

}  // namespace

template <class Message>
void RatedTopic::advertise(ros::NodeHandle& node, const std::string& name, bool latch) {
  publisher_ = node.advertise<Message>(
      name, kQueue, [this](const ros::SingleSubscriberPublisher&) { new_subscriber_ = true; },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), latch);
}

bool RatedTopic::due(bool news, bool last, bool repeat) {
  if (publisher_.getNumSubscribers() == 0) return false;
  const bool urgent = new_subscriber_.exchange(false) || (news && last);
  const WallClock::time_point now = WallClock::now();
  const bool old = repeat && now - gate_.latest() > std::chrono::seconds(1);
  if (!news && !urgent && !old) return false;
  return gate_.pass(now, urgent);
}

template <class Message>
void RatedTopic::publish(const Message& message) {
  messages_ += 1;
  bytes_ += ros::serialization::serializationLength(message);
  publisher_.publish(message);
}

TopicLoad RatedTopic::load() const {
  TopicLoad load;
  load.name = publisher_.getTopic();
  load.subscribers = publisher_.getNumSubscribers();
  load.messages = messages_;
  load.bytes = bytes_;
  return load;
}

Topics::Topics(ros::NodeHandle& node, const NodeParameters& parameters)
    : scene_frame_(parameters.scene_frame),
      rgb_(parameters.particles_rgb),
      stride_(static_cast<std::size_t>(parameters.particles_stride)),
      springs_max_(static_cast<std::size_t>(parameters.springs_max)),
      particles_(parameters.particles_rate_hz),
      springs_(parameters.springs_rate_hz),
      colliders_(30.0),
      state_(parameters.state_rate_hz) {
  particles_.advertise<sensor_msgs::PointCloud2>(node, "particles");
  springs_.advertise<visualization_msgs::MarkerArray>(node, "springs");
  colliders_.advertise<visualization_msgs::MarkerArray>(node, "colliders", true);
  state_.advertise<State>(node, "state");
}

void Topics::sceneStarted(const Simulation& simulation, const ros::Time& stamp) {
  news_ = {true, true, false, true};
  colliders_.publish(colliderMarkers(simulation, header(stamp)));
}

void Topics::publish(const Simulation& simulation, const Snapshot& snapshot, const ros::Time& stamp,
                     bool colliders_moved, bool settled) {
  if (snapshot.report.frame != frame_ || settled != settled_) {
    frame_ = snapshot.report.frame;
    settled_ = settled;
    news_.particles = news_.springs = news_.state = true;
  }
  news_.colliders = news_.colliders || colliders_moved;
  if (particles_.due(news_.particles, settled)) publishParticles(simulation, header(stamp));
  const bool springs = snapshot.report.springs > 0 || drawn_springs_ > 0;
  if (springs_.due(news_.springs && springs, settled, springs))
    publishSprings(simulation, header(stamp));
  if (news_.colliders && colliders_.due(true, settled)) {
    news_.colliders = false;
    colliders_.publish(colliderMarkers(simulation, header(stamp)));
  }
  if (state_.due(news_.state, settled)) {
    news_.state = false;
    State state = stateMessage(snapshot, header(stamp));
    state.topics = loads();
    state_.publish(state);
  }
}

void Topics::publishParticles(const Simulation& simulation, const std_msgs::Header& header) {
  news_.particles = false;
  simulation.sample(particle_samples_, stride_);
  cloud_.header = header;
  const bool heat = simulation.scene().thermal.enabled;
  const Colouring coloured = heat ? Colouring::kHeat : Colouring::kScene;
  writeCloud(particle_samples_, rgb_ ? coloured : Colouring::kPlain, cloud_);
  particles_.publish(cloud_);
}

void Topics::publishSprings(const Simulation& simulation, const std_msgs::Header& header) {
  news_.springs = false;
  simulation.sampleSprings(spring_samples_, springs_max_);
  const bool clear = spring_samples_.size() < drawn_springs_ || spring_samples_.empty();
  drawn_springs_ = spring_samples_.size();
  const double width_m = 0.08 * simulation.scene().fluid.spacing_m;
  springs_.publish(springMarkers(spring_samples_, header, width_m, clear));
}

std::vector<TopicLoad> Topics::loads() const {
  return {particles_.load(), springs_.load(), colliders_.load(), state_.load()};
}

std_msgs::Header Topics::header(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = scene_frame_;
  return header;
}

}  // namespace ice_ice_baby
