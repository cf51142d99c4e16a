#include "loading/block_frames.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Roll, pitch and yaw of a rotation, as poseOf takes them. With a pitch of 90 degrees, roll is 0.
Vec3d rpyOf_deg(const Mat3<double>& r) {
  const double pitch = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  const bool upright = std::abs(r(2, 0)) > 1 - 1e-12;
  const double roll = upright ? 0.0 : std::atan2(r(2, 1), r(2, 2));
  const double yaw = upright ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
  return Vec3d(roll, pitch, yaw) * (180.0 / M_PI);
}

std::optional<Posed> poseOfCollider(const Scene& scene, const std::string& name) {
  std::optional<Posed> pose;
  forEachCollider(scene, [&](const Collider& c) {
    if (c.name == name) pose = poseOf(c.position_m, c.rpy_deg);
  });
  return pose;
}

[[noreturn]] void refuse(const Scene& scene, const std::string& key, const std::string& frame) {
  std::vector<std::string> names;
  forEachCollider(scene, [&](const Collider& c) { names.push_back(c.name); });
  throw InvalidInput(key + " = " + shortened(frame) + " is no collider of the scene" +
                     (names.empty() ? ", which has none" : "; there are: " + joined(names)));
}

void place(Block& block, const Posed& pose, const std::string& key) {
  const Vec3d half = (block.max_m - block.min_m) / 2;
  const Vec3d centre = pose.toWorld(block.centre_m());
  block.min_m = centre - half;
  block.max_m = centre + half;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string place = std::string("xyz").substr(std::size_t(axis), 1) +
                              " in m of the block that " + key + " places";
    requireInRange(place, block.min_m[axis], kCoordinateRange_m.min, kCoordinateRange_m.max);
    requireInRange(place, block.max_m[axis], kCoordinateRange_m.min, kCoordinateRange_m.max);
  }
  const Mat3<double> turn = pose.rotation;
  block.rpy_deg = rpyOf_deg(turn * poseOf(Vec3d::Zero(), block.rpy_deg).rotation);
  block.velocity_m_s = turn * block.velocity_m_s;
  block.angular_velocity_rad_s = turn * block.angular_velocity_rad_s;
  block.velocity_gradient_1_s = turn * block.velocity_gradient_1_s * turn.transpose();
}

}  // namespace

void placeInFrames(Scene& scene) {
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    Block& block = scene.blocks[k];
    if (block.frame.empty()) continue;
    const std::string key = "blocks." + std::to_string(k) + ".frame";
    const std::optional<Posed> pose = poseOfCollider(scene, block.frame);
    if (!pose) refuse(scene, key, block.frame);
    place(block, *pose, key);
    block.frame.clear();
  }
}

}  // namespace ice_ice_baby
