// The topics that follow the simulation: particles, springs, colliders and state.
#pragma once

#include <ice_ice_baby/TopicLoad.h>
#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "pacing.h"
#include "parameters.h"
#include "simulation_thread.h"

namespace ice_ice_baby {

/// A publisher that counts, and that says when a message is due.
class RatedTopic {
 public:
  template <class Message>
  void advertise(ros::NodeHandle& node, const std::string& name, bool latch = false);

  explicit RatedTopic(double rate_hz) : gate_(rate_hz) {}

  /// Whether to build a message: somebody subscribes, and either there is news and the rate allows
  /// it, or the subscriber is new, or the last message is a second old.
  /// @param news since the last message @param last of its kind for a while, so it must go out
  /// @param repeat whether what is a second old goes out again without news
  bool due(bool news, bool last, bool repeat = true);

  template <class Message>
  void publish(const Message& message);

  TopicLoad load() const;

 private:
  ros::Publisher publisher_;
  RateGate gate_;
  std::atomic<bool> new_subscriber_{false};
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> bytes_{0};
};

class Topics {
 public:
  Topics(ros::NodeHandle& node, const NodeParameters& parameters);

  /// The scene stands at its start: its colliders go out, latched.
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp);

  /// Publishes what is due. @param colliders_moved since the last call
  /// @param settled whether no frame follows by itself
  void publish(const Simulation& simulation, const Snapshot& snapshot, const ros::Time& stamp,
               bool colliders_moved, bool settled);

  /// From any thread: what each topic has cost.
  std::vector<TopicLoad> loads() const;

  std_msgs::Header header(const ros::Time& stamp) const;

 private:
  void publishParticles(const Simulation& simulation, const std_msgs::Header& header);
  void publishSprings(const Simulation& simulation, const std_msgs::Header& header);

  const std::string scene_frame_;
  const bool rgb_;
  const std::size_t stride_;
  const std::size_t springs_max_;
  RatedTopic particles_;
  RatedTopic springs_;
  RatedTopic colliders_;
  RatedTopic state_;

  /// News of a scene that some topic has not told yet.
  struct News {
    bool particles = false, springs = false, colliders = false, state = false;
  };
  News news_;
  std::uint64_t frame_ = 0;
  bool settled_ = false;
  std::size_t drawn_springs_ = 0;
  std::vector<ParticleSample> particle_samples_;
  std::vector<SpringSample> spring_samples_;
  sensor_msgs::PointCloud2 cloud_;
};

}  // namespace ice_ice_baby
