// XSPH viscosity (Schechter & Bridson 2012): a particle takes on some of its neighbours' velocity.
#pragma once

#include "ice_ice_baby/kernels.h"
#include "ice_ice_baby/neighbours.h"
#include "ice_ice_baby/pair_passes.h"
#include "ice_ice_baby/particles.h"

namespace ice_ice_baby {

template <class Real>
class Viscosity {
 public:
  /// @param volume_m3 m / rho_0; the factor that makes the coefficient independent of scale
  Viscosity(const Scene& scene, double volume_m3);

  /// v_i += c sum_j V (v_j - v_i) W_ij, with c = 1 - exp(-rate dt), so that the viscosity does not
  /// depend on the number of substeps. Conserves momentum.
  void apply(Particles<Real>& particles, const Neighbours<Real>& neighbours, double dt_s);

  std::size_t bytes() const {
    return positions_.bytes() + velocities_.bytes() + differences_.bytes();
  }

 private:
  CubicSpline<Real> kernel_;
  Real volume_;
  double rate_1_s_;
  PairPasses<Real> passes_;
  PackedRows<Real> positions_;     ///< (n, 4) m
  PackedRows<Real> velocities_;    ///< (n, 4) m/s, so that no particle reads what another wrote
  VectorField<Real> differences_;  ///< (n) m/s
};

}  // namespace ice_ice_baby
