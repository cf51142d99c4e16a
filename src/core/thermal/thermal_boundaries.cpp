#include "thermal/thermal_boundaries.h"

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

template <class Real>
ThermalBoundaries<Real>::ThermalBoundaries(const Scene& scene, const Colliders<Real>& colliders,
                                           const ConductionLattice& lattice,
                                           const EnthalpyCurve& curve)
    : colliders_(colliders),
      curve_(curve),
      spacing_(static_cast<Real>(lattice.spacing_m)),
      radius_(spacing_ / 2),
      support_(static_cast<Real>(lattice.support_m)),
      area_(static_cast<Real>(lattice.area_m2)),
      share_(lattice.support_m, [&](double distance) { return lattice.wallShare(distance); }) {
  forEachCollider(scene, [&](const Collider& c) {
    surfaces_.push_back({c.name, c.heat, c.flux_w_m2, c.celsius, c.celsius, 0.0});
  });
}

template <class Real>
const typename ThermalBoundaries<Real>::Surface& ThermalBoundaries<Real>::surface(
    const std::string& name) const {
  std::vector<std::string> names;
  for (const Surface& one : surfaces_) {
    if (one.name == name) return one;
    names.push_back(one.name);
  }
  throw InvalidInput("no collider \"" + shortened(name) + "\"; the scene has: " + joined(names));
}

template <class Real>
void ThermalBoundaries<Real>::set(const std::string& name, double celsius, double ramp_s) {
  auto& one = const_cast<Surface&>(surface(name));
  one.heat = ThermalBoundary::kTemperature;
  one.target_c = celsius;
  one.ramp_left_s = ramp_s;
  if (ramp_s <= 0.0) one.celsius = celsius;
}

template <class Real>
void ThermalBoundaries<Real>::advance(double dt_s) {
  for (Surface& one : surfaces_) {
    const double part = one.ramp_left_s > dt_s ? dt_s / one.ramp_left_s : 1.0;
    one.celsius = part < 1.0 ? one.celsius + part * (one.target_c - one.celsius) : one.target_c;
    one.ramp_left_s = std::max(one.ramp_left_s - dt_s, 0.0);
  }
}

template <class Real>
bool ThermalBoundaries<Real>::active() const {
  return std::any_of(surfaces_.begin(), surfaces_.end(),
                     [](const Surface& one) { return one.heat != ThermalBoundary::kInsulated; });
}

template <class Real>
bool ThermalBoundaries<Real>::mirrors(std::size_t collider) const {
  return surfaces_[collider].heat != ThermalBoundary::kTemperature;
}

template <class Real>
double ThermalBoundaries<Real>::celsius(const std::string& name) const {
  return surface(name).celsius;
}

/// Calls visit(surface, distance, curvature) for what is nearer than `reach` and not insulated;
/// curvature is 1 for a flat wall and for a ball the conductance of its shell over that.
template <class Real>
template <class Visit>
void ThermalBoundaries<Real>::forEachNear(const Vec3<Real>& point, Real reach,
                                          const Visit& visit) const {
  const Surface* next = surfaces_.data();
  for (const auto& body : colliders_.containers) {
    const Surface& one = *next++;
    if (one.heat == ThermalBoundary::kInsulated) continue;
    const auto near = nearWalls(body.shape, body.motion.to.toLocal(point), radius_, reach);
    for (const NearWall<Real>& wall : near) visit(one, wall.distance, Real(1));
  }
  for (const auto& body : colliders_.planes) {
    const Surface& one = *next++;
    if (one.heat == ThermalBoundary::kInsulated) continue;
    const Real height = heightAbove(body, point, radius_);
    if (height < 0 || height >= reach) continue;
    const Vec3<Real> foot = point - height * body.motion.to.rotation.col(2);
    if (!hiddenByWall<Real>(colliders_, point, foot, radius_, false)) visit(one, height, Real(1));
  }
  for (const auto& body : colliders_.spheres) {
    const Surface& one = *next++;
    if (one.heat == ThermalBoundary::kInsulated) continue;
    const Vec3<Real> out = point - body.motion.to.position;
    const Real distance = out.norm();
    const Real ball = body.shape.reach - radius_;
    const Real gap = distance - ball;
    if (gap >= reach || distance == 0) continue;
    const Vec3<Real> foot = point - out * (gap / distance);
    if (hiddenByWall<Real>(colliders_, point, foot, radius_, false)) continue;
    visit(one, gap, ball / std::max(distance, ball));
  }
}

template <class Real>
WallContact<Real> ThermalBoundaries<Real>::at(const Vec3<Real>& point) const {
  WallContact<Real> contact;
  forEachNear(point, support_, [&](const Surface& one, Real distance, Real curvature) {
    // Closer than this a centre is by error only, and the conductance must stay finite.
    const Real s = std::max(distance, spacing_ / 4);
    const Real area = area_ * share_.at(s).first;
    if (one.heat == ThermalBoundary::kFlux)
      contact.power_w += area * static_cast<Real>(one.flux_w_m2);
    if (one.heat == ThermalBoundary::kTemperature) {
      contact.add(curvature * area / s, curve_.potential(one.celsius));
    }
  });
  return contact;
}

template <class Real>
WallContact<Real> ThermalBoundaries<Real>::touching(const Vec3<Real>& point) const {
  WallContact<Real> contact;
  forEachNear(point, spacing_, [&](const Surface& one, Real, Real) {
    if (one.heat == ThermalBoundary::kTemperature) contact.add(1, one.celsius);
  });
  return contact;
}

template <class Real>
Index ThermalBoundaries<Real>::colderThan(double celsius, const Vec3<Real>& point) const {
  Index found = kNone;
  const Real touch = Real(1.5) * radius_;  // half a radius further than where particles rest
  forEachNear(point, touch, [&](const Surface& one, Real, Real) {
    if (one.heat != ThermalBoundary::kTemperature || one.celsius >= celsius || found != kNone)
      return;
    found = static_cast<Index>(&one - surfaces_.data());
  });
  return found;
}

template class ThermalBoundaries<float>;
template class ThermalBoundaries<double>;

}  // namespace ice_ice_baby
