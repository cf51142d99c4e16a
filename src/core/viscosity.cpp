#include "ice_ice_baby/viscosity.h"

#include <cmath>
#include <utility>

#include "ice_ice_baby/parallel.h"

namespace ice_ice_baby {

template <class Real>
Viscosity<Real>::Viscosity(const Scene& scene, double volume_m3)
    : kernel_(static_cast<Real>(scene.supportRadius_m())),
      volume_(static_cast<Real>(volume_m3)),
      rate_1_s_(scene.solver.viscosity_1_s) {}

template <class Real>
void Viscosity<Real>::apply(Particles<Real>& particles, const Neighbours<Real>& neighbours,
                            double dt_s) {
  const std::size_t n = particles.size();
  const Real factor = volume_ * static_cast<Real>(1.0 - std::exp(-rate_1_s_ * dt_s));
  const VectorField<Real>& x = particles.predicted;
  const VectorField<Real>& v = particles.velocity;
  const Real h2 = kernel_.h * kernel_.h;
  smoothed_.resize(n);
  parallelFor(n, [&](std::size_t i) {
    const Vec3<Real> xi = x.at(i);
    const Vec3<Real> vi = v.at(i);
    Vec3<Real> sum = Vec3<Real>::Zero();
    for (const Index j : neighbours.of(i)) {
      const Real r2 = (xi - x.at(j)).squaredNorm();
      if (r2 < h2) sum += (v.at(j) - vi) * kernel_.w(std::sqrt(r2));
    }
    smoothed_.set(i, vi + factor * sum);
  });
  std::swap(particles.velocity, smoothed_);
}

template class Viscosity<float>;
template class Viscosity<double>;

}  // namespace ice_ice_baby
