// tf frames of the scene and its colliders, and colliders that follow a tf frame.
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "parameters.h"
#include "tf_listening.h"

namespace ice_ice_baby {

/// Publishes frame_id -> scene_frame and fixed colliders on /tf_static, colliders that follow a
/// frame (followers) on /tf. Listens to tf only while the scene has a follower.
class Frames {
 public:
  Frames(ros::NodeHandle& node, const NodeParameters& parameters);

  /// A scene is at its start. Like the next two functions, it does not block.
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp);

  /// Moves each follower to the present pose of its frame, if tf has one.
  void moveFollowers(Simulation& simulation);

  /// Publishes the poses of the followers. @returns whether one has moved since the last call
  bool publishFollowers(const Simulation& simulation, const ros::Time& stamp);

  /// One line per follower that does not move because its frame is missing or its pose is invalid,
  /// and per frame that tf rejects.
  std::vector<std::string> lost() const;

  /// Followers that moved faster than solver.max_speed_m_s, which makes them jump.
  struct Jumps {
    std::uint64_t count = 0;  ///< since the node started
    std::string latest;       ///< collider and distance
  };
  Jumps jumps() const;

 private:
  /// A collider that is fixed to a tf frame, at `offset` in it.
  struct Follower {
    std::string name;
    std::string frame;
    Posed offset;
    Posed published;
  };

  std::string frameOf(const std::string& collider) const { return scene_frame_ + "/" + collider; }
  /// Drops transforms from before ROS time jumped back.
  void clearAfterJump();
  void setLost(std::vector<std::string> lost);
  /// @param from, to positions before and after one frame
  void noteJump(const Follower& follower, const Scene& scene, const Vec3d& from, const Vec3d& to);

  const std::string parent_;
  const std::string scene_frame_;
  const Posed scene_pose_;
  ros::Publisher dynamic_;
  ros::Publisher static_;
  std::vector<Follower> followers_;  ///< simulation's thread, with the next two
  ros::Time latest_;
  ros::WallTime clear_at_;  ///< 0: no jump

  tf2_ros::Buffer buffer_;
  mutable std::mutex mutex_;  ///< guards the next two
  std::vector<std::string> lost_;
  Jumps jumps_;
  TfListening listening_;
};

}  // namespace ice_ice_baby
