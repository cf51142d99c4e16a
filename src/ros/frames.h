// tf: where the scene and its colliders stand, and colliders that follow a frame.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "parameters.h"
#include "tf_watch.h"

namespace ice_ice_baby {

/// Publishes frame_id -> scene_frame and colliders that stay on /tf_static, colliders that follow a
/// frame on /tf. Listens to tf only while the scene has a follower.
class Frames {
 public:
  /// @param scene the first one, listened for as by listenFor()
  Frames(ros::NodeHandle& node, const NodeParameters& parameters, const Scene& scene);

  /// Listens to tf if `scene` has a follower; may wait for the master, so not for the simulation's
  /// thread. To be called when the scene is to come.
  void listenFor(const Scene& scene);

  /// Listens no longer if neither the scene that runs nor `coming` has a follower. May wait.
  void listenLess(const Scene& coming);

  /// The scene stands at its start.
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp);

  /// Moves each follower to where its frame is now, if tf knows; never waits.
  void moveFollowers(Simulation& simulation);

  /// Publishes where the followers are. @returns whether one has moved since the last call
  bool publishFollowers(const Simulation& simulation, const ros::Time& stamp);

  /// One line per follower that stands still because tf does not know its frame, or because its
  /// pose cannot be used, and per frame that tf refuses.
  std::vector<std::string> lost() const;

 private:
  /// A collider and the frame that it is fixed to, at the pose that the scene gives it there.
  struct Follower {
    std::string name;
    std::string frame;
    Posed offset;
    Posed published;
  };

  std::string frameOf(const std::string& collider) const { return scene_frame_ + "/" + collider; }
  /// Forgets transforms from before a jump back of ROS time.
  void clearAfterJump();
  void setLost(std::vector<std::string> lost);

  const std::string parent_;
  const std::string scene_frame_;
  const Posed scene_pose_;
  ros::Publisher dynamic_;
  ros::Publisher static_;
  std::vector<Follower> followers_;  ///< the simulation thread's own, as the next two
  ros::Time latest_;
  ros::WallTime clear_at_;  ///< 0: no jump

  /// What is there while a scene has a follower.
  struct Listener {
    Listener(ros::NodeHandle& node, tf2_ros::Buffer& buffer) : tf(buffer), watch(node) {}

    tf2_ros::TransformListener tf;
    TfWatch watch;
  };

  ros::NodeHandle node_;
  tf2_ros::Buffer buffer_;
  mutable std::mutex listener_mutex_;  ///< guards listener_
  std::unique_ptr<Listener> listener_;
  std::atomic<bool> follows_{false};  ///< whether the scene that runs has a follower
  mutable std::mutex mutex_;          ///< guards lost_
  std::vector<std::string> lost_;
};

}  // namespace ice_ice_baby
