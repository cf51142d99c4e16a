// How well each pair of neighbours conducts, but for the conductivities, which change with each
// pass: measured once a frame.
#pragma once

#include <vector>

#include "ice_ice_baby/heat_mirrors.h"
#include "ice_ice_baby/neighbours.h"

namespace ice_ice_baby {

/// What a frame gives to heat.
template <class Real>
struct HeatStep {
  double dt_s = 0.0;                                 ///< simulated
  double air_c = 20.0;                               ///< of the air
  const std::vector<std::uint8_t>* steam = nullptr;  ///< (n) which are puffs of steam; null: none
  const std::vector<Real>* volume = nullptr;  ///< (n) over that of water; null: 1 for all of them
};

template <class Real>
class HeatLinks {
 public:
  HeatLinks(const Colliders<Real>& colliders, const HeatWalls<Real>& walls,
            const HeatLattice& lattice);

  /// Makes room for the links of all lists, to be measured next.
  void begin(const VectorField<Real>& x, const Neighbours<Real>& neighbours);

  struct Sum {
    Real length_m = 0;                        ///< of all links of a particle
    Vec3<Real> open_m2 = Vec3<Real>::Zero();  ///< area that links leave bare, pointing inwards
  };
  /// Measures the links of one particle, each as HeatLattice::length_m has it.
  Sum measure(std::size_t i, const VectorField<Real>& x, const Neighbours<Real>& neighbours,
              const HeatStep<Real>& step);

  /// Length in m of each link of a particle, in the order of its list. A pair has one length.
  const Real* of(std::size_t i) const { return lengths_.data() + start_[i]; }

  std::size_t bytes() const {
    return start_.capacity() * sizeof(std::size_t) + lengths_.capacity() * sizeof(Real) +
           mirrors_.bytes();
  }

 private:
  /// L(r) of two particles, 0 beyond the support radius.
  Real length(Real distance2) const;

  HeatMirrors<Real> mirrors_;
  bool has_mirrors_;
  Real support_;
  Real scale_;                      ///< of length
  std::vector<std::size_t> start_;  ///< (n) first link
  std::vector<Real> lengths_;       ///< of all lists
};

}  // namespace ice_ice_baby
