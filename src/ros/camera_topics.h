// Topics of the cameras: pictures of depth, and of what is where.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "own_frames.h"
#include "pacing.h"
#include "publisher_thread.h"
#include "seen_shapes.h"
#include "tf_listening.h"

namespace ice_ice_baby {

/// cameras/NAME/depth/image_raw and cameras/NAME/label/image_raw, each with camera_info, for every
/// camera of the scene. The simulation's thread takes a snapshot when a camera with subscribers is
/// due; a thread of this class makes the pictures. Meanwhile no other snapshot is taken, so slow
/// pictures skip frames and never hold up the solver. Listens to tf only while a camera that
/// follows a frame has subscribers.
class CameraTopics {
 public:
  /// @param node with the private names
  CameraTopics(const ros::NodeHandle& node, std::string scene_frame);

  /// Simulation's thread, like the next one: replaces the topics of an earlier scene.
  void sceneStarted(const std::shared_ptr<const Scene>& scene);
  /// Takes and hands over a snapshot for the cameras that are due; does not wait.
  /// @param last whether no frame follows by itself
  void publish(const Simulation& simulation, const ros::Time& stamp, bool last);

 private:
  struct Topic {
    Topic(ros::NodeHandle& node, const Camera& of);
    bool subscribed() const;

    Camera camera;
    ros::Publisher depth, depth_info, label, label_info;
    std::shared_ptr<std::atomic<bool>> joined;  ///< whether a subscriber is new
    RateGate gate;
    std::uint64_t frame = ~std::uint64_t{0};  ///< of the latest picture
  };
  struct Cameras {
    std::shared_ptr<const Scene> scene;
    std::optional<SeenShapes> shapes;  ///< from the first picture on; thread of this class
    std::vector<std::unique_ptr<Topic>> topics;
  };

  void end();
  bool placed(const Camera& camera) const;
  static bool due(Topic& topic, std::uint64_t frame, bool last);
  void makePictures();
  void makePicture(RayScene& rays, const Topic& topic);
  Posed poseNow(const Camera& camera) const;

  ros::NodeHandle node_;
  const std::string scene_frame_;
  std::shared_ptr<Cameras> cameras_;  ///< simulation's thread; null without cameras

  /// Written by the simulation's thread while the other is not busy, read by that while it is.
  struct {
    ros::Time stamp;
    std::vector<ParticleSample> samples;
    SeenShapes::Places places;
    std::shared_ptr<Cameras> cameras;
    std::vector<const Topic*> due;
  } snapshot_;

  tf2_ros::Buffer buffer_;
  const OwnFrames none_;  ///< cameras may follow the frames that this node sends
  TfListening listening_;
  PublisherThread thread_;  ///< last, so that it ends first
};

}  // namespace ice_ice_baby
