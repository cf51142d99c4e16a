// XSPH viscosity (Schechter & Bridson 2012): a particle takes on some of its neighbours' velocity.
#pragma once

#include "fluid/pair_passes.h"
#include "particles/kernels.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"

namespace ice_ice_baby {

template <class Real>
class Viscosity {
 public:
  /// @param volume_m3 m / rho_0; the factor that makes the coefficient independent of scale
  /// @param phases what is water, ice and steam, or null where all is water
  Viscosity(const Scene& scene, double volume_m3, const Phases<Real>* phases = nullptr);

  /// v_i += c sum_j V (v_j - v_i) W_ij, with c = 1 - exp(-rate dt), so that the viscosity does not
  /// depend on the number of substeps. Conserves momentum. In a mixture c rises to 1/2 with the ice
  /// fraction of both, what is beyond that of water along the line between them only, so that slush
  /// stiffens before it freezes and keeps its angular momentum. Two particles of ice have none, nor
  /// has steam.
  /// @param scratch for the positions: any rows whose values nobody needs any more
  /// @param densest largest density over that at rest: c is at most its inverse, for what all
  /// neighbours together overshoot grows from substep to substep
  void apply(Particles<Real>& particles, const Neighbours<Real>& neighbours, double dt_s,
             PackedXyzw<Real>& scratch, double densest = 1.0);

  std::size_t bytes() const { return velocities_.bytes() + grip_.capacity() * sizeof(Real); }

 private:
  void packMixture(const Particles<Real>& particles, Real share, Real most);

  CubicSpline<Real> kernel_;
  Real volume_;
  double rate_1_s_;
  const Phases<Real>* phases_;
  PairPasses<Real> passes_;
  std::vector<Real> grip_;       ///< (n) c of a particle; only in a mixture
  PackedXyzw<Real> velocities_;  ///< (n, 4) m/s, so that no particle reads what another wrote
};

}  // namespace ice_ice_baby
