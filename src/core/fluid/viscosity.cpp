#include "fluid/viscosity.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

template <class Real>
Viscosity<Real>::Viscosity(const Scene& scene, double volume_m3, const Phases<Real>* phases)
    : kernel_(static_cast<Real>(scene.supportRadius_m())),
      volume_(static_cast<Real>(volume_m3)),
      rate_1_s_(scene.solver.viscosity_1_s),
      phases_(phases),
      passes_(phases ? mixturePairPasses<Real>(KernelPair::kCubic)
                     : pairPasses<Real>(KernelPair::kCubic)) {}

template <class Real>
void Viscosity<Real>::apply(Particles<Real>& particles, const Neighbours<Real>& neighbours,
                            double dt_s, PackedXyzw<Real>& scratch, double densest) {
  const std::size_t n = particles.size();
  const double max = 1.0 / std::max(densest, 1.0);
  const Real share = static_cast<Real>(std::min(1.0 - std::exp(-rate_1_s_ * dt_s), max));
  scratch.pack(particles.predicted);
  if (phases_) {
    packMixture(particles, share, static_cast<Real>(max));
  } else {
    velocities_.pack(particles.velocity);
  }
  // In a mixture each particle has its own coefficient.
  const Real factor = volume_ * (phases_ ? Real(1) : share) * kernel_.w(0);
  const PairInput<Real> pairs{neighbours, scratch.data(), velocities_.data(),
                              kernel_.h,  nullptr,        share};
  parallelForRanges(n, [&](std::size_t first, std::size_t last) {
    passes_.addDifferences(pairs, factor, particles.velocity, {first, last});
  });
}

template <class Real>
void Viscosity<Real>::packMixture(const Particles<Real>& particles, Real share, Real max) {
  constexpr Real kSlushShare(0.5);  // all neighbours together must not overshoot
  const Real rise = std::max(Real(0), std::min(kSlushShare, max) - share);
  grip_.resize(particles.size());
  parallelFor(particles.size(), [&](std::size_t i) {
    const Real own = phases_->steam(i) ? Real(0) : share + rise * phases_->slush()[i];
    grip_[i] = phases_->rigid(i) ? static_cast<Real>(kRigidGrip) : own;
  });
  velocities_.pack(particles.velocity, grip_);
}

template class Viscosity<float>;
template class Viscosity<double>;

}  // namespace ice_ice_baby
