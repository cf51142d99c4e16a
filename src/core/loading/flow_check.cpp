#include "loading/flow_check.h"

#include "base/item_names.h"
#include "flow/outlet.h"

namespace ice_ice_baby {

namespace {

/// Directions shorter than this, m, count as 0.
constexpr double kShortest = 1e-12;

void requireSpeed(const Scene& scene, const Source& source, const std::string& words) {
  const bool both = source.speed_m_s > 0.0 && source.flow_l_min > 0.0;
  if (both || source.speedInForce_m_s() == 0.0) {
    throw InvalidInput(words + ": speed_m_s = " + numberText(source.speed_m_s) +
                       " and flow_l_min = " + numberText(source.flow_l_min) +
                       "; set exactly one of them above 0, the other follows from radius_m");
  }
  const double speed_m_s = source.speedInForce_m_s();
  if (speed_m_s <= scene.solver.max_speed_m_s) return;
  throw InvalidInput(
      words + ": the water would leave with " + numberText(speed_m_s) +
      " m/s, above solver.max_speed_m_s = " + numberText(scene.solver.max_speed_m_s) +
      "; lower speed_m_s or flow_l_min, enlarge radius_m, or raise the limit");
}

void requireLiquid(const Scene& scene, const Source& source, const std::string& words) {
  const ThermalParams& thermal = scene.thermal;
  if (!thermal.enabled) return;
  requireInRange(words + ".temperature_c, from thermal.freezing_c to thermal.boiling_c,",
                 source.temperature_c, thermal.freezing_c, thermal.boiling_c);
}

void requireWithinBounds(const BoundsParams& bounds, const Outlet& outlet, const Posed& pose,
                         const std::string& words) {
  for (const Vec3d& local : outlet.sites) {
    const Vec3d site = pose.toWorld(local);
    for (int axis = 0; axis < 3; ++axis) {
      requireInRange(
          words + ": " + "xyz"[axis] + " in m of a place that water leaves, within bounds,",
          site[axis], bounds.min_m[axis], bounds.max_m[axis]);
    }
  }
}

void requireOutlet(const Scene& scene, const Source& source, const std::string& words) {
  if (source.direction.norm() < kShortest) {
    throw InvalidInput(words + ": direction = [0, 0, 0] has no direction; give a vector that " +
                       "points along the flow, as [0, 0, -1]");
  }
  const double d = scene.fluid.spacing_m;
  const double sites = siteCount(source, d);
  const double most = std::min(kMaxSites, scene.limits.max_particles);
  if (sites > most) {
    throw InvalidInput(words + ": a disc of radius_m = " + numberText(source.radius_m) + " emits " +
                       numberText(sites) + " particles at a time, more than " + numberText(most) +
                       "; lower radius_m, enlarge fluid.spacing_m, or raise limits.max_particles");
  }
  // A source with a follow_frame has no place in the scene yet.
  if (!source.follow_frame.empty()) return;
  requireWithinBounds(scene.bounds, Outlet(source, d), source.pose(), words);
}

void requireBox(const Drain& drain, const std::string& words) {
  for (int axis = 0; axis < 3; ++axis) {
    if (drain.min_m[axis] < drain.max_m[axis]) continue;
    const std::string part = "." + std::to_string(axis);
    throw InvalidInput(words + ": min_m" + part + " = " + numberText(drain.min_m[axis]) +
                       " must be below max_m" + part + " = " + numberText(drain.max_m[axis]));
  }
}

}  // namespace

void requireFlow(const Scene& scene) {
  requireNames(scene.sources, "source");
  requireNames(scene.drains, "drain");
  for (std::size_t k = 0; k < scene.sources.size(); ++k) {
    const Source& source = scene.sources[k];
    const std::string words = wordsFor("sources", k, source);
    requireFollowFrame(source, "source");
    requireSpeed(scene, source, words);
    requireLiquid(scene, source, words);
    requireOutlet(scene, source, words);
  }
  for (std::size_t k = 0; k < scene.drains.size(); ++k) {
    requireBox(scene.drains[k], wordsFor("drains", k, scene.drains[k]));
  }
}

}  // namespace ice_ice_baby
