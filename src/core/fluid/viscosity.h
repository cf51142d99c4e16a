// XSPH viscosity (Schechter & Bridson 2012): smooths velocities over neighbours.
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
  /// fraction of both particles, so that slush stiffens before it freezes. The part beyond that of
  /// water acts only along the line between them, which conserves angular momentum. There is none
  /// between two particles of ice, nor for steam.
  /// @param scratch memory for the positions; its contents are overwritten
  /// @param densest largest density relative to rest. c is limited to its inverse, because a
  /// crowded particle that overshoots the mean velocity of its neighbours diverges
  void apply(Particles<Real>& particles, const Neighbours<Real>& neighbours, double dt_s,
             PackedXyzw<Real>& scratch, double densest = 1.0);

  std::size_t bytes() const { return velocities_.bytes() + grip_.capacity() * sizeof(Real); }

 private:
  void packMixture(const Particles<Real>& particles, Real share, Real max);

  CubicSpline<Real> kernel_;
  Real volume_;
  double rate_1_s_;
  const Phases<Real>* phases_;
  PairPasses<Real> passes_;
  std::vector<Real> grip_;       ///< (n) c of each particle; only in a mixture
  PackedXyzw<Real> velocities_;  ///< (n, 4) m/s, a copy, as velocities are updated in place
};

}  // namespace ice_ice_baby
