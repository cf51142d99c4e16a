#include "thermal/thermal_boundaries.h"

#include <cmath>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Exponent of flatness in the flux that a particle receives. It would be 2 if the layers around a
/// ball held particles in proportion to their area. The first one, which receives most of the flux,
/// holds a few percent fewer. Measured around balls of 2 to 8 spacings: doc/solids.md.
constexpr double kFluxExponent = 1.7;

}  // namespace

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

/// Calls visit(surface, distance, flatness) for what is nearer than `reach` and not insulated;
/// flatness is the conductance of a curved shell over that of a flat wall.
template <class Real>
template <class Visit>
void ThermalBoundaries<Real>::forEachNear(const Vec3<Real>& point, Real reach,
                                          const Visit& visit) const {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const Surface& one = surfaces_[k];
    if (one.heat == ThermalBoundary::kInsulated) continue;
    const Shape<Real>& shape = colliders_[k].shape;
    const Pose<Real>& pose = colliders_[k].motion.to;
    for (const NearSurface<Real>& near : shape.near(pose.toLocal(point), reach)) {
      const Vec3<Real> foot = point - near.distance * (pose.rotation * near.normal);
      if (!shape.hollow() && colliders_.hidden(point, foot)) continue;
      visit(one, near.distance, near.flatness);
    }
  }
}

template <class Real>
WallContact<Real> ThermalBoundaries<Real>::at(const Vec3<Real>& point) const {
  WallContact<Real> contact;
  forEachNear(point, support_, [&](const Surface& one, Real distance, Real flatness) {
    // Centres come closer than this only by error; keeps the conductance finite.
    const Real s = std::max(distance, spacing_ / 4);
    const Real area = area_ * share_.at(s).first;
    if (one.heat == ThermalBoundary::kFlux) {
      contact.power_w += std::pow(flatness, static_cast<Real>(kFluxExponent)) * area *
                         static_cast<Real>(one.flux_w_m2);
    }
    if (one.heat == ThermalBoundary::kTemperature) {
      contact.add(flatness * area / s, curve_.potential(one.celsius));
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
  const Real touch = Real(1.5) * radius_;  // half a radius beyond the distance at rest
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
