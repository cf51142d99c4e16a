// The lattice of water at rest that walls stand for.
#pragma once

#include <array>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Flat walls count as if water at rest went on behind them, its first layer half a spacing deep.
/// So a lattice at rest in a box has exactly the rest density everywhere.
class RestLattice {
 public:
  /// @param volume_m3 m / rho_0, the volume of a particle
  RestLattice(const Scene& scene, double volume_m3);

  double support_m() const { return h_; }

  /// Relative density of the lattice behind `walls` walls at right angles, in the region behind all
  /// of them, at these distances from them, m.
  double behind(const std::array<double, 3>& distances, int walls) const;

 private:
  KernelPair kernel_;
  double h_, spacing_, volume_;
};

}  // namespace ice_ice_baby
