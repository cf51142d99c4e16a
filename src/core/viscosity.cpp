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
                            double dt_s) {
  const std::size_t n = particles.size();
  const Real share = static_cast<Real>(1.0 - std::exp(-rate_1_s_ * dt_s));
  const Real factor = volume_ * share * kernel_.w(0);
  positions_.pack(particles.predicted);
  velocities_.pack(particles.velocity);
  differences_.resize(n);
  const PairInput<Real> pairs{neighbours, positions_.data(), velocities_.data(), kernel_.h};
  parallelForRanges(n, [&](std::size_t first, std::size_t last) {
    passes_.sumDifferences(pairs, differences_, {first, last});
    for (std::size_t i = first; i < last; ++i) {
      particles.velocity.add(i, factor * differences_.at(i));
    }
  });
}

template class Viscosity<float>;
template class Viscosity<double>;

}  // namespace ice_ice_baby
