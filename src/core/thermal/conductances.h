// How well each pair of neighbours conducts, but for the conductivities, which change with each
// pass: measured once a frame.
#pragma once

#include <vector>

#include "particles/neighbours.h"
#include "thermal/adiabatic_mirrors.h"
#include "thermal/conductance_pass.h"

namespace ice_ice_baby {

/// What a frame gives to heat.
template <class Real>
struct ThermalStep {
  double dt_s = 0.0;                                 ///< simulated
  double air_c = 20.0;                               ///< of the air
  const std::vector<std::uint8_t>* steam = nullptr;  ///< (n) which are puffs of steam; null: none
  const std::vector<Real>* volume = nullptr;  ///< (n) over that of water; null: 1 for all of them
};

template <class Real>
class Conductances {
 public:
  Conductances(const Colliders<Real>& colliders, const ThermalBoundaries<Real>& walls,
               const ConductionLattice& lattice);

  /// Makes room for the links of all lists, to be measured next.
  void begin(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
             const ThermalStep<Real>& step);

  /// Measures the links of some particles.
  /// @param total_m (n) sum of the lengths of a particle
  /// @param open_m2 (n) area that links leave bare, pointing inwards
  void measure(const VectorField<Real>& x, const Neighbours<Real>& neighbours, ParticleRange range,
               std::vector<Real>& total_m, VectorField<Real>& open_m2);

  /// Each link of a particle in the order of its list: of two particles the same from both sides,
  /// its length over scale_m().
  const Real* of(std::size_t i) const { return links_.data() + start_[i]; }
  Real scale_m() const { return scale_; }

  std::size_t bytes() const {
    return start_.capacity() * sizeof(std::size_t) +
           (links_.capacity() + presence_.capacity()) * sizeof(Real) + rows_.bytes() +
           mirrors_.bytes();
  }

 private:
  Real addImages(std::size_t i, const VectorField<Real>& x, const Neighbours<Real>& neighbours);

  ConductancePass<Real> pass_ = conductancePass<Real>();
  AdiabaticMirrors<Real> mirrors_;
  bool has_mirrors_;
  CubicSpline<Real> kernel_;
  Real scale_;                      ///< ConductionLattice::length_m(h / 2)
  std::vector<std::size_t> start_;  ///< (n) first link
  std::vector<Real> links_;         ///< of all lists
  std::vector<Real> presence_;      ///< (n) relative volume; 0 of steam
  PackedXyzw<Real> rows_;           ///< (n, 4) x_i and presence
};

}  // namespace ice_ice_baby
