#include "ice_ice_baby/viscosity.h"

#include <cmath>

#include "ice_ice_baby/parallel.h"

namespace ice_ice_baby {

template <class Real>
Viscosity<Real>::Viscosity(const Scene& scene, double volume_m3)
    : kernel_(static_cast<Real>(scene.supportRadius_m())),
      volume_(static_cast<Real>(volume_m3)),
      rate_1_s_(scene.solver.viscosity_1_s),
      passes_(pairPasses<Real>(KernelPair::kCubic)) {}

template <class Real>
void Viscosity<Real>::apply(Particles<Real>& particles, const Neighbours<Real>& neighbours,
                            double dt_s, PackedRows<Real>& scratch) {
  const std::size_t n = particles.size();
  const Real share = static_cast<Real>(1.0 - std::exp(-rate_1_s_ * dt_s));
  const Real factor = volume_ * share * kernel_.w(0);
  scratch.pack(particles.predicted);
  velocities_.pack(particles.velocity);
  const PairInput<Real> pairs{neighbours, scratch.data(), velocities_.data(), kernel_.h};
  parallelForRanges(n, [&](std::size_t first, std::size_t last) {
    passes_.addDifferences(pairs, factor, particles.velocity, {first, last});
  });
}

template class Viscosity<float>;
template class Viscosity<double>;

}  // namespace ice_ice_baby
