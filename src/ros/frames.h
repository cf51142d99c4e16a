// tf: where the scene and its colliders stand, and colliders that follow a frame.
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

/// Publishes frame_id -> scene_frame and colliders that stay on /tf_static, colliders that follow a
/// frame on /tf. Listens to tf only while the scene has a follower.
class Frames {
 public:
  Frames(ros::NodeHandle& node, const NodeParameters& parameters);

  /// The scene stands at its start; never waits, as the next two.
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp);

  /// Moves each follower to where its frame is now, if tf knows.
  void moveFollowers(Simulation& simulation);

  /// Publishes where the followers are. @returns whether one has moved since the last call
  bool publishFollowers(const Simulation& simulation, const ros::Time& stamp);

  /// One line per follower that stands still because tf does not know its frame, or because its
  /// pose cannot be used, and per frame that tf refuses.
  std::vector<std::string> lost() const;

  /// Followers that went further in a frame than the speed limit, so that they jumped.
  struct Jumps {
    std::uint64_t count = 0;  ///< since the node started
    std::string latest;       ///< which, how far
  };
  Jumps jumps() const;

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
  /// @param from, to of a frame
  void noteJump(const Follower& follower, const Scene& scene, const Vec3d& from, const Vec3d& to);

  const std::string parent_;
  const std::string scene_frame_;
  const Posed scene_pose_;
  ros::Publisher dynamic_;
  ros::Publisher static_;
  std::vector<Follower> followers_;  ///< the simulation thread's own, as the next two
  ros::Time latest_;
  ros::WallTime clear_at_;  ///< 0: no jump

  tf2_ros::Buffer buffer_;
  mutable std::mutex mutex_;  ///< guards the next two
  std::vector<std::string> lost_;
  Jumps jumps_;
  TfListening listening_;
};

}  // namespace ice_ice_baby
