// Commands of users between frames. Each is checked completely before anything changes.
#include <algorithm>
#include <set>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

bool still(const Vec3d& a, const Vec3d& b) { return (a - b).squaredNorm() == 0.0; }

/// @param what it is the pose of
void requirePose(const std::string& what, const Posed& pose) {
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange("position of " + what, pose.position[axis], kCoordinateRange_m.min,
                   kCoordinateRange_m.max);
  }
  // A reflection is unitary too, but its determinant is -1.
  const auto& rotation = pose.rotation;
  if (!rotation.allFinite() || !rotation.isUnitary(1e-6) || rotation.determinant() < 0.0) {
    throw InvalidInput("rotation of " + what + " must be a unit quaternion");
  }
}

void requireHeat(const Scene& scene, const std::string& what) {
  if (scene.thermal.enabled) return;
  throw InvalidInput(what + " needs a scene with thermal.enabled: true, as iceberg; scene " +
                     scene.name + " has one temperature for all of it");
}

/// Number of the item with this name. @param noun of an item
/// @throws InvalidInput if there is none
template <class Item>
std::size_t numberOf(const Scene& scene, const std::vector<Item>& items, const std::string& noun,
                     const std::string& name) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return std::size_t(found - names.begin());
  throw InvalidInput("no " + noun + " \"" + shortened(name) + "\"; scene " + scene.name +
                     (names.empty() ? " has none" : " has: " + joined(names)));
}

std::size_t numberOfSource(const Scene& scene, const std::string& name) {
  return numberOf(scene, scene.sources, "source", name);
}

std::size_t numberOfHeatRegion(const Scene& scene, const std::string& name) {
  return numberOf(scene, scene.heat_regions, "heat region", name);
}

}  // namespace

template <class Real>
void Simulator<Real>::setTemperature(double celsius, double ramp_s, const std::string& target) {
  requireTemperature(celsius, ramp_s);
  requireTarget(scene_, target);
  if (!target.empty()) return phase_change_->heat()->setWall(target, celsius, ramp_s);
  temperature_.set(celsius, ramp_s);
  updateTemperature(report_.time_s);
}

template <class Real>
void Simulator<Real>::heatRegion(const HeatedRegion& region) {
  requireHeatedRegion(scene_, region);
  if (phase_change_->heat()->regions() >= kMaxHeatedRegions) {
    throw InvalidInput(std::to_string(kMaxHeatedRegions) +
                       " regions are heated or cooled already; wait until one of them ends");
  }
  phase_change_->heat()->addRegion(region);
}

template <class Real>
void Simulator<Real>::setHeatRegion(const std::string& name, bool active, double power_w) {
  requireHeatRegion(scene_, name, power_w);
  HeatRegionParams& region = scene_.heat_regions[numberOfHeatRegion(scene_, name)];
  region.active = active;
  if (power_w != 0.0) region.power_w = power_w;
}

template <class Real>
void Simulator<Real>::moveHeatRegion(const std::string& name, const Posed& pose) {
  const std::size_t k = numberOfHeatRegion(scene_, name);
  requirePose("heat region " + name, pose);
  phase_change_->heat()->sceneRegions()->move(k, pose);
}

template <class Real>
Posed Simulator<Real>::heatRegionPose(const std::string& name) const {
  const std::size_t k = numberOfHeatRegion(scene_, name);
  return phase_change_->heat()->sceneRegions()->pose(k);
}

template <class Real>
void Simulator<Real>::setSource(const std::string& name, bool open, double flow_l_min) {
  requireSource(scene_, name, flow_l_min);
  Source& source = scene_.sources[numberOfSource(scene_, name)];
  source.open = open;
  if (flow_l_min > 0.0) {
    source.flow_l_min = flow_l_min;
    source.speed_m_s = 0.0;
  }
  report_.sources_stopped = sources_->stopped(scene_, room());
  if (open) wake();
}

template <class Real>
void Simulator<Real>::moveSource(const std::string& name, const Posed& pose) {
  const std::size_t k = numberOfSource(scene_, name);
  requirePose("source " + name, pose);
  sources_->motion(k).moveTo(pose);
}

template <class Real>
void Simulator<Real>::placeSource(const std::string& name, const Posed& pose) {
  const std::size_t k = numberOfSource(scene_, name);
  requirePose("source " + name, pose);
  sources_->motion(k).place(pose);
}

template <class Real>
Posed Simulator<Real>::sourcePose(const std::string& name) const {
  const std::size_t k = numberOfSource(scene_, name);
  return sources_->motion(k).at(0.0);
}

template <class Real>
void Simulator<Real>::setGravity(const Vec3d& gravity_m_s2) {
  requireGravity(gravity_m_s2);
  if (still(gravity_m_s2, scene_.gravity_m_s2)) return;
  scene_.gravity_m_s2 = gravity_m_s2;
  wake();
}

template <class Real>
void Simulator<Real>::requirePlacement(const std::string& name, const Posed& pose) const {
  colliders_.pose(name);  // throws for an unknown name
  requirePose("collider " + name, pose);
}

/// Number of a solid that is in the scene now.
template <class Real>
Index Simulator<Real>::requireSolid(const std::string& name) const {
  const Index solid = ice_ice_baby::requireSolid(scene_, name);
  if (bodies()->bodyOfSolid(solid) != kNone) return solid;
  throw InvalidInput("solid " + name + " has left the bounds of the scene; reset the scene");
}

template <class Real>
Posed Simulator<Real>::solidPose(const std::string& name) const {
  return bodies()->solidState(bodies()->bodyOfSolid(requireSolid(name))).pose;
}

template <class Real>
void Simulator<Real>::holdSolid(const std::string& name, const Posed& pose) {
  const Index solid = requireSolid(name);
  requirePose("solid " + name, pose);
  phase_change_->grip(solid, pose);
  report_.asleep = false;
  still_s_ = 0.0;
}

template <class Real>
void Simulator<Real>::releaseSolid(const std::string& name) {
  phase_change_->letGo(requireSolid(name));
}

template <class Real>
void Simulator<Real>::requirePlacements(const std::vector<ColliderPlacement>& placements) const {
  std::set<std::string> placed;
  for (const auto& [name, pose] : placements) {
    requirePlacement(name, pose);
    if (placed.insert(name).second) continue;
    throw InvalidInput("collider " + name + " is placed twice; give it one pose");
  }
}

template <class Real>
void Simulator<Real>::moveCollider(const std::string& name, const Posed& pose) {
  requirePlacement(name, pose);
  const Posed now = colliders_.pose(name);
  const bool there = still(now.position, pose.position) && now.rotation == pose.rotation;
  if (there && !colliders_moving_) return;
  colliders_.moveTo(name, pose);
  colliders_moving_ = true;
  wake();
}

template <class Real>
void Simulator<Real>::placeColliders(const std::vector<ColliderPlacement>& placements) {
  requirePlacements(placements);
  std::vector<Jump<Real>> jumps;
  for (const auto& [name, pose] : placements) {
    const Posed now = colliders_.pose(name);
    const bool there = still(now.position, pose.position) && now.rotation == pose.rotation;
    if (there && !colliders_moving_) continue;
    jumps.push_back(colliders_.place(name, pose));
  }
  if (jumps.empty()) return;
  arena_.execute([&] { carryAlong(jumps); });
  observeVessels();
  wake();
}

void requireTemperature(double celsius, double ramp_s) {
  requireInRange("temperature in degrees Celsius", celsius, kTemperatureRange_c.min,
                 kTemperatureRange_c.max);
  requireInRange("ramp in seconds", ramp_s, 0.0, 1e6);
}

void requireTarget(const Scene& scene, const std::string& target) {
  if (target.empty()) return;
  requireHeat(scene, "a temperature of collider \"" + shortened(target) + "\"");
  std::vector<std::string> names;
  forEachCollider(scene, [&](const Collider& c) { names.push_back(c.name); });
  if (std::find(names.begin(), names.end(), target) == names.end()) {
    throw InvalidInput("no collider \"" + shortened(target) + "\"; scene " + scene.name +
                       " has: " + joined(names) + "; \"\" is the air");
  }
}

void requireHeatedRegion(const Scene& scene, const HeatedRegion& region) {
  requireHeat(scene, "heating a region");
  if (region.shape == BlockShape::kCylinder) {
    throw InvalidInput("a heated region is a box or a sphere, not a cylinder");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = std::string(" ") + "xyz"[axis] + " of the region in m";
    requireInRange("centre" + name, region.centre_m[axis], kCoordinateRange_m.min,
                   kCoordinateRange_m.max);
    requireInRange("size" + name, region.size_m[axis], 0.0, 2 * kMaxCoordinate_m);
  }
  requireInRange("power in watts", region.power_w, kPowerRange_w.min, kPowerRange_w.max);
  requireInRange("duration in seconds", region.duration_s, 0.0, 1e6);
}

void requireHeatRegion(const Scene& scene, const std::string& name, double power_w) {
  numberOfHeatRegion(scene, name);  // throws for an unknown name
  requireInRange("power of heat region " + name + " in watts", power_w, kPowerRange_w.min,
                 kPowerRange_w.max);
}

void requireSource(const Scene& scene, const std::string& name, double flow_l_min) {
  const Source& source = scene.sources[numberOfSource(scene, name)];
  const double fastest_l_min = scene.solver.max_speed_m_s * source.area_m2() * kLitresPerMinute;
  requireInRange("flow of source " + name + " in l/min", flow_l_min, 0.0,
                 std::min(fastest_l_min, kFlowRange_l_min.max));
}

Index requireSolid(const Scene& scene, const std::string& name) {
  return static_cast<Index>(numberOf(scene, scene.solids, "solid", name));
}

void requireGravity(const Vec3d& gravity_m_s2) {
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange(std::string("gravity ") + "xyz"[axis] + " in m/s^2", gravity_m_s2[axis],
                   kGravityRange_m_s2.min, kGravityRange_m_s2.max);
  }
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
