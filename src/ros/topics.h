// The topics that follow the simulation: particles, springs, colliders, state, vessels, wrenches,
// floating solids and cameras.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <memory>
#include <string>
#include <vector>

#include "camera_topics.h"
#include "parameters.h"
#include "particle_cloud.h"
#include "publisher_thread.h"
#include "rated_topic.h"
#include "simulation_thread.h"
#include "solid_topics.h"
#include "wrench_topics.h"

namespace ice_ice_baby {

/// The simulation's thread takes a snapshot of each topic that is due; a thread of this class
/// builds the message and publishes it. A topic without subscribers costs neither. While a snapshot
/// waits or is published no other is taken of that topic, so a slow publisher skips frames and
/// never holds up the solver.
class Topics {
 public:
  Topics(ros::NodeHandle& node, const NodeParameters& parameters);

  /// Simulation's thread: a scene is at its start. The next call of publish sends its colliders,
  /// latched.
  void sceneStarted(const Simulation& simulation);

  /// Simulation's thread: flows are counted, and wrenches measured, in the frame that begins if
  /// anyone subscribes to them.
  void frameBegins(Simulation& simulation);

  /// Simulation's thread: takes and hands over the snapshots that are due; does not wait.
  /// @param colliders_moved since the last call
  /// @param settled whether no frame follows by itself
  void publish(const Simulation& simulation, const Snapshot& snapshot, const ros::Time& stamp,
               bool colliders_moved, bool settled);

  /// Any thread: what each topic has cost.
  std::vector<TopicLoad> loads() const;

  std_msgs::Header header(const ros::Time& stamp) const;

 private:
  enum Topic : std::size_t { kParticles, kSprings, kColliders, kState, kVessels };

  /// What happened since the last snapshot of a topic.
  struct News {
    bool any = false;
    bool last = false;  ///< no frame followed by itself
    void add(bool settled) {
      any = true;
      last = last || settled;
    }
  };

  void addNews(const Snapshot& snapshot, bool colliders_moved, bool settled);
  void takeParticles(const Simulation& simulation, const ros::Time& stamp);
  void takeSprings(const Simulation& simulation, const ros::Time& stamp);
  void takeColliders(const Simulation& simulation, const ros::Time& stamp);
  void takeVessels(const Simulation& simulation, const ros::Time& stamp);
  void publishParticles();
  void publishSprings();
  void publishColliders();
  void publishState();
  void publishVessels();

  void startCameras();

  ros::NodeHandle node_;
  const std::string scene_frame_;
  const bool rgb_;
  const std::size_t stride_;
  const std::size_t springs_max_;
  RatedTopic particles_;
  RatedTopic springs_;
  RatedTopic colliders_;
  RatedTopic state_;
  RatedTopic vessels_;
  WrenchTopics wrenches_;  ///< simulation's thread, like the next two
  SolidTopics solids_;
  std::unique_ptr<CameraTopics> cameras_;  ///< from the first scene with cameras on

  // Simulation's thread.
  News particle_news_, spring_news_, collider_news_, state_news_, vessel_news_, wrench_news_;
  std::shared_ptr<const Scene> scene_;
  bool scene_started_ = false;
  std::uint64_t frame_ = 0;
  bool settled_ = false;
  std::size_t taken_springs_ = 0;

  // Snapshots: written by the simulation's thread while their topic is not busy, read by the
  // publisher's thread while it is.
  struct {
    ros::Time stamp;
    Colouring colouring = Colouring::kPlain;
    std::vector<ParticleSample> samples;
  } particle_snapshot_;
  struct {
    ros::Time stamp;
    double width_m = 0.0;
    bool clear = false;  ///< whether lines of the message before are deleted
    std::vector<SpringSample> samples;
  } spring_snapshot_;
  struct {
    ros::Time stamp;
    std::shared_ptr<const Scene> scene;
    std::vector<Posed> poses;  ///< in the order of forEachCollider
  } collider_snapshot_;
  struct {
    ros::Time stamp;
    Snapshot snapshot;
  } state_snapshot_;
  struct {
    ros::Time stamp;
    double time_s = 0.0;
    std::uint64_t spilled = 0;
    std::vector<VesselReport> vessels;
  } vessel_snapshot_;

  boost::shared_ptr<sensor_msgs::PointCloud2> cloud_;  ///< publisher's thread
  PublisherThread publisher_;                          ///< last, so that it ends first
};

}  // namespace ice_ice_baby
