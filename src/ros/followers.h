// What follows a tf frame: colliders, sources and heat regions, and floating solids that are
// attached.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "motion_limit.h"
#include "own_frames.h"
#include "parameters.h"
#include "pose_playback.h"
#include "steered.h"
#include "tf_listening.h"

namespace ice_ice_baby {

/// Moves parts of the scene as their frames moved, a little later (PosePlayback), within the bounds
/// of the parameters (MotionLimit). The first pose of a frame places its part. In simulated time a
/// frame of the simulation waits for the transforms of its stamp, at most ~tf_wait_s of wall time.
/// Listens to tf only while there is a follower. A solid that is attached keeps the place relative
/// to its frame that it has when the first pose of the frame arrives; until then it stays where it
/// is.
class Followers {
 public:
  /// @param own frames that this node sends itself; must outlive this object
  Followers(const ros::NodeHandle& node, const NodeParameters& parameters, const OwnFrames& own);

  /// Simulation's thread, like the next five: a scene is at its start. Does not block.
  void sceneStarted(const Simulation& simulation);
  /// Names of the colliders of the scene that follow a frame.
  const std::vector<std::string>& colliders() const { return colliders_; }
  /// Whether anything follows a frame now.
  bool any() const { return any_; }
  /// Attaches a solid to a tf frame; with an empty frame lets it go. @throws InvalidInput if it has
  /// left the scene
  void attach(Simulation& simulation, const std::string& solid, const std::string& frame);
  /// A transform that this node sends.
  void addOwn(const geometry_msgs::TransformStamped& transform, bool is_static);
  /// Moves each follower, over the next frame, to the pose for the stamp of this frame.
  void move(Simulation& simulation, const ros::Time& stamp);

  /// Any thread, like the next one: one line per follower that does not move because its frame is
  /// missing or its pose is invalid, and per frame that tf rejects.
  std::vector<std::string> lost() const;

  /// What happened since the node started.
  struct Count {
    std::uint64_t count = 0;
    std::string latest;  ///< what of the scene, and what happened
  };
  struct Report {
    Count jumps;    ///< faster than solver.max_speed_m_s
    Count bounded;  ///< frames in which a follower was behind because of its bounds
    Count waits;    ///< frames that waited in vain for the transforms of their stamp
    struct Frame {
      std::string follower;  ///< its name
      double age_s = 0.0;    ///< of the newest pose, at the latest frame
      double rate_hz = 0.0;  ///< of poses; 0 for a frame that is fixed
      double delay_s = 0.0;
    };
    std::vector<Frame> frames;  ///< that have a pose
  };
  Report report() const;

 private:
  /// A part that is fixed to a tf frame, at its pose in it.
  struct Follower {
    Steered what;  ///< its pose is that in the frame; of a solid known once it is placed
    PosePlayback playback;
    MotionLimit limit;
    std::string missing;         ///< why tf has no pose, "" if it has one
    std::optional<Posed> fixed;  ///< pose of a frame that only static transforms lead to
    ros::Time newest;            ///< stamp of the newest sample
    bool placed = false;
    bool late = false;  ///< a frame waited in vain; no other one does until a sample arrives

    bool solid() const { return what.kind == SteeredKind::kSolid; }
  };
  /// Where a follower goes in a frame.
  struct Target {
    Follower* follower;
    Posed pose;
    bool placed;
  };

  double secondsOf(const ros::Time& time);
  PlaybackSettings settingsFor(const Scene& scene) const;
  void detach(const std::string& solid);
  void startSolid(const Simulation& simulation, Follower& follower, const Posed& frame);
  void collect();
  void collect(Follower& follower, double now_s);
  bool ready(const Follower& follower, double stamp_s) const;
  void await(std::unique_lock<std::mutex>& lock, double stamp_s);
  std::vector<Target> play(double stamp_s);
  void place(Simulation& simulation, const std::vector<Target>& targets,
             std::vector<std::string>& lost);
  void moveOne(Simulation& simulation, const Target& target, std::vector<std::string>& lost);
  static std::string wordsFor(const Follower& follower);
  static std::string lineOf(const Follower& follower, const std::string& why);
  void noteJump(const Follower& follower, double distance_m);
  void noteBounded(const Follower& follower, const MotionLimit::Step& step);
  void clearAfterJump();
  void setLost(std::vector<std::string> lost);

  const std::string scene_frame_;
  const PlaybackSettings settings_;
  const double wait_s_;  ///< wall time
  const MotionBounds bounds_;
  const double frames_per_frame_;  ///< ROS time of a frame over its simulated time
  bool any_ = false;               ///< simulation's thread, up to clear_at_
  std::vector<std::string> colliders_;
  double frame_s_ = 1.0 / 60.0;  ///< simulated time of a frame
  double teleport_m_s_ = 0.0;
  ros::Time latest_;
  ros::WallTime clear_at_;  ///< 0: no jump

  tf2_ros::Buffer buffer_;
  mutable std::mutex mutex_;  ///< guards what follows, up to report_
  std::condition_variable arrived_;
  ros::Time origin_;  ///< of times in seconds, 0: none yet
  double stamp_s_ = 0.0;
  std::vector<Follower> followers_;
  std::vector<std::string> lost_;
  Report report_;
  TfListening listening_;
};

}  // namespace ice_ice_baby
