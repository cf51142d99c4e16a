// tf frames of the scene, its colliders and its floating solids.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "followers.h"
#include "frame_clash.h"
#include "own_frames.h"

namespace ice_ice_baby {

/// Publishes frame_id -> scene_frame and fixed colliders on /tf_static, colliders that follow a
/// frame (followers) or are dragged, and floating solids on /tf.
class Frames {
 public:
  Frames(ros::NodeHandle& node, const NodeParameters& parameters);

  /// A scene is at its start. Like the next five, on the simulation's thread.
  /// @param dragged colliders that move without following a frame
  void sceneStarted(const Simulation& simulation, const ros::Time& stamp,
                    const std::vector<std::string>& dragged = {});

  /// Whether anything follows a frame.
  bool follows() const { return followers_.any(); }

  /// Moves each follower as its frame moved until `stamp`. May wait in simulated time; see
  /// Followers.
  void moveFollowers(Simulation& simulation, const ros::Time& stamp) {
    followers_.move(simulation, stamp);
  }

  /// As Followers::attach.
  void attach(Simulation& simulation, const std::string& solid, const std::string& frame) {
    followers_.attach(simulation, solid, frame);
  }

  /// Publishes the poses of the solids, once for each stamp.
  void publishSolids(const Simulation& simulation, const ros::Time& stamp);

  /// Publishes the poses of the colliders that move, once for each stamp.
  /// @returns whether one has moved since the last call
  bool publishFollowers(const Simulation& simulation, const ros::Time& stamp);

  /// Any thread, like the next one.
  const Followers& followers() const { return followers_; }
  /// One of the frames that another node sends too, and what to do; "" if there is none.
  std::string clash() const { return clash_.clash(); }

 private:
  std::string frameOf(const std::string& part) const { return scene_frame_ + "/" + part; }

  const std::string parent_;
  const std::string scene_frame_;
  const Posed scene_pose_;
  ros::Publisher dynamic_;
  ros::Publisher static_;
  std::vector<std::string> moving_;  ///< colliders; simulation's thread, with the next three
  std::vector<Posed> published_;     ///< their poses
  ros::Time stamp_;                  ///< of the last message on /tf about colliders
  ros::Time solid_stamp_;            ///< the same about solids
  OwnFrames own_;
  FrameClash clash_;
  Followers followers_;
};

}  // namespace ice_ice_baby
