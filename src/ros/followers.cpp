// Followers: what becomes of their poses. How they arrive is in followers_tf.cpp.
#include "followers.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Distance, m, and angle, rad, from which on a follower counts as behind its frame.
constexpr double kBehind = 5e-4;

PlaybackSettings settingsOf(const NodeParameters& parameters) {
  PlaybackSettings settings;
  settings.delay_s = parameters.tf_delay_s;
  settings.simulated_time = ros::Time::isSimTime();
  return settings;
}

/// With ~publish_clock ROS time is that of the simulation.
double framesPerFrame(const NodeParameters& parameters) {
  const bool own_clock = ros::Time::isSimTime() && parameters.publish_clock;
  return own_clock || parameters.real_time_factor <= 0.0 ? 1.0 : 1.0 / parameters.real_time_factor;
}

/// Rounded to three digits after the point.
std::string roundedText(double value) { return numberText(std::round(1e3 * value) / 1e3); }

}  // namespace

Followers::Followers(const ros::NodeHandle& node, const NodeParameters& parameters,
                     const OwnFrames& own)
    : scene_frame_(parameters.scene_frame),
      settings_(settingsOf(parameters)),
      wait_s_(parameters.tf_wait_s),
      bounds_(motionBounds(parameters)),
      frames_per_frame_(framesPerFrame(parameters)),
      listening_(node, buffer_, own, [this] {
        const std::lock_guard<std::mutex> lock(mutex_);
        collect();
        arrived_.notify_all();
      }) {
  buffer_.setUsingDedicatedThread(true);
}

PlaybackSettings Followers::settingsFor(const Scene& scene) const {
  PlaybackSettings settings = settings_;
  settings.frame_s = std::min(0.1, frames_per_frame_ / scene.solver.frame_rate_hz);
  settings.teleport = {scene.solver.max_speed_m_s / scene.solver.frame_rate_hz,
                       scene.solver.max_speed_m_s};
  return settings;
}

void Followers::sceneStarted(const Simulation& simulation) {
  const SolverParams& solver = simulation.scene().solver;
  const PlaybackSettings settings = settingsFor(simulation.scene());
  frame_s_ = 1.0 / solver.frame_rate_hz;
  teleport_m_s_ = solver.max_speed_m_s;
  colliders_.clear();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    followers_.clear();
    for (const Steered& what : everySteered(simulation.scene())) {
      if (what.follow_frame.empty()) continue;
      if (what.kind == SteeredKind::kCollider) colliders_.push_back(what.name);
      followers_.push_back({what, PosePlayback(settings), MotionLimit(bounds_), "", std::nullopt,
                            ros::Time(), false, false});
    }
    any_ = !followers_.empty();
  }
  listening_.want(any_);
  setLost({});
}

void Followers::addOwn(const geometry_msgs::TransformStamped& transform, bool is_static) {
  buffer_.setTransform(transform, "self", is_static);
}

void Followers::move(Simulation& simulation, const ros::Time& stamp) {
  if (!any_) return;
  clearAfterJump();
  std::vector<Target> targets;
  std::vector<std::string> lost;
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const double stamp_s = secondsOf(stamp);
    collect();
    if (settings_.simulated_time) await(lock, stamp_s);
    stamp_s_ = stamp_s;
    targets = play(stamp_s);
    for (const Follower& follower : followers_) {
      if (!follower.missing.empty()) lost.push_back(lineOf(follower, follower.missing));
    }
  }
  // What this uses of a follower changes on this thread only.
  const auto moving = std::stable_partition(
      targets.begin(), targets.end(),
      [](const Target& target) { return target.placed && !target.follower->solid(); });
  place(simulation, {targets.begin(), moving}, lost);
  for (auto target = moving; target != targets.end(); ++target) moveOne(simulation, *target, lost);
  setLost(std::move(lost));
}

std::vector<Followers::Target> Followers::play(double stamp_s) {
  std::vector<Target> targets;
  for (Follower& follower : followers_) {
    if (!follower.placed) follower.playback.restart();
    std::optional<PosePlayback::Played> played = follower.playback.play(stamp_s);
    if (follower.fixed) played = PosePlayback::Played{*follower.fixed, false};
    if (!played) continue;
    const bool placing = follower.solid() && !follower.placed;  // then its pose is not known yet
    const Posed& offset = follower.what.pose;
    const Posed pose = placing ? played->pose
                               : Posed{played->pose.toWorld(offset.position),
                                       played->pose.rotation * offset.rotation};
    targets.push_back({&follower, pose, played->placed || !follower.placed});
  }
  return targets;
}

/// All together, so that two colliders can change places. If one of them is refused, one by one.
void Followers::place(Simulation& simulation, const std::vector<Target>& targets,
                      std::vector<std::string>& lost) {
  if (targets.empty()) return;
  std::vector<SteeredPlacement> placements;
  for (const Target& target : targets) placements.push_back({target.follower->what, target.pose});
  std::vector<double> distances_m;
  for (const auto& [what, pose] : placements) {
    distances_m.push_back((pose.position - poseNow(simulation, what).position).norm());
  }
  try {
    placeSteered(simulation, placements);
  } catch (const std::exception& e) {
    if (targets.size() > 1) {
      for (const Target& target : targets) place(simulation, {target}, lost);
      return;
    }
    targets.front().follower->placed = false;
    lost.push_back(lineOf(*targets.front().follower, e.what()));
    return;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    Follower& follower = *targets[k].follower;
    if (follower.placed) noteJump(follower, distances_m[k]);
    follower.placed = true;
    follower.limit.start(targets[k].pose);
  }
}

void Followers::moveOne(Simulation& simulation, const Target& target,
                        std::vector<std::string>& lost) {
  Follower& follower = *target.follower;
  if (follower.solid() && !follower.placed) return startSolid(simulation, follower, target.pose);
  const MotionLimit::Step step = follower.limit.step(target.pose, frame_s_);
  try {
    moveSteered(simulation, follower.what, step.pose);
  } catch (const std::exception& e) {
    follower.placed = false;
    lost.push_back(lineOf(follower, e.what()));
    return;
  }
  if (step.behind_m >= kBehind || step.behind_rad >= kBehind) noteBounded(follower, step);
}

std::vector<std::string> Followers::lost() const {
  std::vector<std::string> lines = listening_.refused();
  const std::lock_guard<std::mutex> lock(mutex_);
  lines.insert(lines.end(), lost_.begin(), lost_.end());
  return lines;
}

Followers::Report Followers::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Report report = report_;
  for (const Follower& follower : followers_) {
    const PoseSamples& samples = follower.playback.samples();
    if (follower.fixed) {
      report.frames.push_back({follower.what.name, 0.0, 0.0, 0.0});
    } else if (!samples.empty()) {
      report.frames.push_back({follower.what.name, stamp_s_ - samples.newest().stamp_s,
                               samples.rate_hz(), follower.playback.delay_s()});
    }
  }
  return report;
}

/// "collider ball, which follows tf frame hand"
std::string Followers::wordsFor(const Follower& follower) {
  return follower.what.words() + (follower.solid() ? ", which is attached to" : ", which follows") +
         " tf frame " + follower.what.follow_frame;
}

std::string Followers::lineOf(const Follower& follower, const std::string& why) {
  return wordsFor(follower) + ", does not move: " + why;
}

void Followers::noteJump(const Follower& follower, double distance_m) {
  const std::lock_guard<std::mutex> lock(mutex_);
  report_.jumps.count += 1;
  const bool holds = follower.what.kind == SteeredKind::kCollider;
  report_.jumps.latest = follower.what.words() + " jumped " + roundedText(distance_m) +
                         " m with tf frame " + follower.what.follow_frame +
                         (holds ? " and took its contents along" : "") +
                         ", because the frame moved faster than the " + numberText(teleport_m_s_) +
                         " m/s of solver.max_speed_m_s";
}

void Followers::noteBounded(const Follower& follower, const MotionLimit::Step& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  report_.bounded.count += 1;
  report_.bounded.latest =
      follower.what.words() + " was " + roundedText(step.behind_m) + " m and " +
      roundedText(step.behind_rad) + " rad behind tf frame " + follower.what.follow_frame +
      ", which moves faster than ~tf_max_speed_m_s, ~tf_max_acceleration_m_s2 or "
      "~tf_max_turning_rad_s allow; move it more slowly, or raise them";
}

void Followers::setLost(std::vector<std::string> lost) {
  // Not throttled: a throttled log is silent until a simulated clock ticks.
  if (lost.size() > lost_.size()) ROS_WARN("%s", joined(lost).c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ = std::move(lost);
}

}  // namespace ice_ice_baby
