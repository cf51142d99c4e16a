// Followers: floating solids that are attached to a tf frame.
#include <algorithm>

#include "followers.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Pose of a solid. @throws InvalidInput if it has left the scene
Posed poseNow(const Simulation& simulation, const std::string& name) {
  const std::vector<SolidState> states = simulation.solids();
  const auto found = std::find_if(states.begin(), states.end(),
                                  [&](const SolidState& state) { return state.name == name; });
  if (found != states.end()) return found->pose;
  throw InvalidInput("solid " + name + " has left the bounds of the scene; reset the scene");
}

}  // namespace

void Followers::attach(Simulation& simulation, const std::string& solid, const std::string& frame) {
  const Posed now = poseNow(simulation, solid);
  detach(solid);
  if (frame.empty()) {
    simulation.releaseSolid(solid);
  } else {
    simulation.holdSolid(solid, now);
    const PlaybackSettings settings = settingsFor(simulation.scene());
    const std::lock_guard<std::mutex> lock(mutex_);
    followers_.push_back({solid, frame, Posed(), PosePlayback(settings), MotionLimit(bounds_), "",
                          std::nullopt, ros::Time(), false, false, true});
  }
  any_ = !followers_.empty();
  listening_.want(any_);
}

void Followers::detach(const std::string& solid) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Follower> kept;
  for (Follower& follower : followers_) {
    if (!(follower.solid && follower.name == solid)) kept.push_back(std::move(follower));
  }
  followers_.swap(kept);
}

/// From now on the solid keeps its place relative to the frame.
void Followers::startSolid(const Simulation& simulation, Follower& follower, const Posed& frame) {
  const Posed now = poseNow(simulation, follower.name);
  follower.offset = {frame.toLocal(now.position), frame.rotation.transpose() * now.rotation};
  follower.limit.start(now);
  follower.placed = true;
}

}  // namespace ice_ice_baby
