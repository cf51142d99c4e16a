// What the latest projection of the coarse level did to colliders.
#include "coarse/displacement_projection.h"
#include "coarse/wall_pressure.h"

namespace ice_ice_baby {

/// What walls took from the push on particles that they hold.
template <class Real>
void DisplacementProjection<Real>::addHeldLoads(const Particles<Real>& particles, Real dt,
                                                std::vector<WallLoad<Real>>& loads) const {
  const Real reach = spacing_;
  for (const Index k : touching_) {
    const Index i = grids_.order()[k];
    const Vec3<Real> from = particles.position.at(i);
    const Vec3<Real> given = particles.predicted.at(i) - from - dt * particles.velocity.at(i);
    const Vec3<Real> held = given - pushOn(k);
    if (held.isZero(0)) continue;
    Index nearest = kNone;
    Real least = reach;
    for (std::size_t c = 0; c < colliders_.count(); ++c) {
      for (const NearSurface<Real>& surface :
           colliders_[c].shape.near(colliders_[c].motion.from.toLocal(from), reach)) {
        if (surface.gap >= least) continue;
        least = surface.gap;
        nearest = Index(c);
      }
    }
    if (nearest != kNone) loads.push_back({nearest, from, -held});
  }
}

template <class Real>
void DisplacementProjection<Real>::wallLoads(const Particles<Real>& particles, Real dt,
                                             std::vector<WallLoad<Real>>& loads) const {
  if (active_.empty()) return;
  WallPressure<Real>(grids_, colliders_, mu_, left_).addLoads(loads);
  addHeldLoads(particles, dt, loads);
}

template class DisplacementProjection<float>;
template class DisplacementProjection<double>;

}  // namespace ice_ice_baby
