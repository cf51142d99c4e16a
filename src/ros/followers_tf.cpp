// Followers: how the poses of their frames arrive.
#include <ros/console.h>
#include <ros/init.h>

#include <algorithm>
#include <chrono>

#include "followers.h"
#include "geometry.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// While it waits for transforms, a frame asks this often whether the node shuts down.
constexpr std::chrono::milliseconds kPoll{100};

}  // namespace

/// Differences of ros::Time throw beyond 68 years.
double Followers::secondsOf(const ros::Time& time) {
  if (origin_.isZero()) origin_ = time;
  return (double(time.sec) - double(origin_.sec)) +
         (double(time.nsec) - double(origin_.nsec)) / 1e9;
}

void Followers::collect() {
  const double now_s = secondsOf(ros::Time::now());
  for (Follower& follower : followers_) collect(follower, now_s);
}

void Followers::collect(Follower& follower, double now_s) {
  try {
    const auto found =
        buffer_.lookupTransform(scene_frame_, follower.what.follow_frame, ros::Time(0));
    const Posed pose = poseOf(found.transform);
    follower.missing.clear();
    follower.fixed.reset();
    if (found.header.stamp.isZero()) {
      follower.fixed = pose;
    } else if (found.header.stamp != follower.newest) {
      follower.newest = found.header.stamp;
      follower.playback.add({secondsOf(found.header.stamp), now_s, pose});
      follower.late = false;
    }
  } catch (const std::exception& e) {
    follower.missing = e.what();
  }
}

bool Followers::ready(const Follower& follower, double stamp_s) const {
  const PoseSamples& samples = follower.playback.samples();
  return follower.fixed || follower.late || samples.count() < 2 ||
         samples.newest().stamp_s >= follower.playback.neededStamp_s(stamp_s);
}

/// A robot in simulated time sends the transforms of a stamp soon after it, however slow the water.
void Followers::await(std::unique_lock<std::mutex>& lock, double stamp_s) {
  const auto all_ready = [&] {
    return std::all_of(followers_.begin(), followers_.end(),
                       [&](const Follower& follower) { return ready(follower, stamp_s); });
  };
  using Clock = std::chrono::steady_clock;
  const auto wait =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s_));
  const auto end = Clock::now() + wait;
  while (!all_ready() && ros::ok() && Clock::now() < end) {
    arrived_.wait_until(lock, std::min(end, Clock::now() + kPoll));
  }
  if (all_ready() || !ros::ok()) return;
  for (Follower& follower : followers_) {
    if (ready(follower, stamp_s)) continue;
    follower.late = true;
    report_.waits.count += 1;
    report_.waits.latest =
        "a frame waited " + numberText(wait_s_) + " s for the pose of " + wordsFor(follower) +
        ", and went on without it; the robot has to send a transform for each message on /clock, "
        "or at a steady rate; raise ~tf_wait_s for a slower robot";
    ROS_WARN("%s", report_.waits.latest.c_str());
  }
}

/// TfFeed clears the buffer at the jump, but an old transform that arrives afterwards would make
/// tf2 reject all newer ones. So the buffer is cleared again once late transforms have arrived.
void Followers::clearAfterJump() {
  const ros::Time now = ros::Time::now();
  if (now < latest_) clear_at_ = ros::WallTime::now() + ros::WallDuration(0.5);
  latest_ = now;
  if (clear_at_.isZero() || ros::WallTime::now() < clear_at_) return;
  clear_at_ = ros::WallTime();
  buffer_.clear();
}

}  // namespace ice_ice_baby
