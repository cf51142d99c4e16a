// Conduction on the rest lattice, which calibrates conduction between particles.
#pragma once

#include "ice_ice_baby/scene.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

/// The heat flow between two particles at distance r is k L (T_j - T_i) watts, with the length
/// L = 2 V (-W'(r) / r) / S. W is the cubic spline (Cleary & Monaghan 1999). S is the second moment
/// of -W' / r over the lattice, which makes the Laplacian of x^2 exact there; without it the cubic
/// spline has an error of 2 %.
class ConductionLattice {
 public:
  explicit ConductionLattice(const Scene& scene);

  double spacing_m;
  double support_m;
  double volume_m3;  ///< V of a particle
  double mass_kg;
  double moment_1_m3;  ///< S
  double links_m;      ///< sum of L over all pairs of a particle in the bulk
  double area_m2;      ///< V / d: area of a particle at a flat surface

  /// L of two particles at the given distance, m.
  double length_m(double distance_m) const;

  /// Fraction of `area_m2` through which a particle at a distance from a flat wall exchanges heat
  /// with it: that of the pairs if the lattice continued behind the wall, its first layer half a
  /// spacing deep. The fractions of the layers of the rest lattice add up to 1.
  double wallShare(double distance_m) const;

 private:
  CubicSpline<double> kernel_;
};

}  // namespace ice_ice_baby
