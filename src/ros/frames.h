// tf: where the scene and its colliders stand, and colliders that follow a frame.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "parameters.h"

namespace ice_ice_baby {

/// Publishes frame_id -> scene_frame and colliders that stay on /tf_static, colliders that follow a
/// frame on /tf. Listens to tf only while the scene has a follower.
class Frames {
 public:
  /// @param scene the first one, prepared as by prepare()
  Frames(ros::NodeHandle& node, const NodeParameters& parameters, const Scene& scene);

  /// Listens to tf if `scene` has a follower; may wait for the master, so not for the simulation's
  /// thread. To be called before the scene starts.
  void prepare(const Scene& scene);

  /// The scene stands at its start.
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp);

  /// Moves each follower to where its frame is now, if tf knows; never waits.
  void moveFollowers(Simulation& simulation);

  /// Publishes where the followers are. @returns whether one has moved since the last call
  bool publishFollowers(const Simulation& simulation, const ros::Time& stamp);

  /// One line per follower that stands still because tf does not know its frame, or because its
  /// pose cannot be used.
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
  void setLost(std::vector<std::string> lost);

  const std::string parent_;
  const std::string scene_frame_;
  const Posed scene_pose_;
  ros::Publisher dynamic_;
  ros::Publisher static_;
  std::vector<Follower> followers_;  ///< the simulation thread's own

  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  mutable std::mutex mutex_;  ///< guards lost_
  std::vector<std::string> lost_;
};

}  // namespace ice_ice_baby
