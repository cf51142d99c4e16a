#include "phase/steam.h"

#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Factor on the rise speed of a particle, from 1/2 to 3/2, spread evenly by the golden ratio; 1
/// for the first. Steam that boils off together disperses.
double haste(std::uint32_t id) {
  return 0.5 + std::fmod(0.5 + 0.6180339887498949 * double(id), 1.0);
}

}  // namespace

template <class Real>
void Steam<Real>::predict(Particles<Real>& particles, const Phases<Real>& phases,
                          const Vec3d& gravity_m_s2, double dt_s) const {
  const double g = gravity_m_s2.norm();
  const Vec3d up = g > 0.0 ? Vec3d(-gravity_m_s2 / g) : Vec3d(Vec3d::Zero());
  const Vec3<Real> risen = (params_.rise_speed_m_s * up).template cast<Real>();
  const Vec3<Real> fallen = (dt_s * gravity_m_s2).template cast<Real>();
  const Real taken = static_cast<Real>(1.0 - std::exp(-params_.drag_1_s * dt_s));
  const Real dt = static_cast<Real>(dt_s);
  parallelFor(particles.size(), [&](std::size_t i) {
    if (!phases.steam(i)) return;
    Vec3<Real> v = particles.velocity.at(i) - fallen;
    v += taken * (static_cast<Real>(haste(particles.id[i])) * risen - v);
    particles.velocity.set(i, v);
    particles.predicted.set(i, particles.position.at(i) + dt * v);
  });
}

template class Steam<float>;
template class Steam<double>;

}  // namespace ice_ice_baby
