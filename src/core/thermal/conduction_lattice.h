// Conduction on the rest lattice, from which all conduction between particles takes its scale.
#pragma once

#include "ice_ice_baby/scene.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

/// Two particles at distance r pass on k L (T_j - T_i) watts with the length L = 2 V (-W'(r) / r) /
/// S, W the cubic spline (Cleary & Monaghan 1999) and S the second moment of -W' / r over the
/// lattice, which makes the Laplacian of x^2 exact there: without it the cubic spline is 2 % off.
class ConductionLattice {
 public:
  explicit ConductionLattice(const Scene& scene);

  double spacing_m;
  double support_m;
  double volume_m3;  ///< V of a particle
  double mass_kg;
  double moment_1_m3;  ///< S
  double links_m;      ///< L of all pairs of a particle in the bulk together
  double area_m2;      ///< V / d: what a particle takes of a flat surface

  /// L of two particles at a distance, m.
  double length_m(double distance_m) const;

  /// Share of `area_m2` that a particle takes of a flat wall at a distance: heat across the wall
  /// that pairs would carry if the lattice went on behind it, the first layer half a spacing deep.
  /// Adds up to 1 over the layers of the rest lattice.
  double wallShare(double distance_m) const;

 private:
  CubicSpline<double> kernel_;
};

}  // namespace ice_ice_baby
