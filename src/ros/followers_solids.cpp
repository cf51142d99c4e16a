// Followers: floating solids that are attached to a tf frame.
#include "followers.h"

namespace ice_ice_baby {

void Followers::attach(Simulation& simulation, const std::string& solid, const std::string& frame) {
  const Steered what{SteeredKind::kSolid, solid, frame, Posed()};
  const Posed now = poseNow(simulation, what);
  detach(solid);
  if (frame.empty()) {
    simulation.releaseSolid(solid);
  } else {
    simulation.holdSolid(solid, now);
    const PlaybackSettings settings = settingsFor(simulation.scene());
    const std::lock_guard<std::mutex> lock(mutex_);
    followers_.push_back({what, PosePlayback(settings), MotionLimit(bounds_), "", std::nullopt,
                          ros::Time(), false, false});
  }
  any_ = !followers_.empty();
  listening_.want(any_);
}

void Followers::detach(const std::string& solid) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Follower> kept;
  for (Follower& follower : followers_) {
    if (!(follower.solid() && follower.what.name == solid)) kept.push_back(std::move(follower));
  }
  followers_.swap(kept);
}

/// From now on the solid keeps its place relative to the frame.
void Followers::startSolid(const Simulation& simulation, Follower& follower, const Posed& frame) {
  const Posed now = poseNow(simulation, follower.what);
  follower.what.pose = {frame.toLocal(now.position), frame.rotation.transpose() * now.rotation};
  follower.limit.start(now);
  follower.placed = true;
}

}  // namespace ice_ice_baby
