// Geometric factor of the conductance of each pair of neighbours, computed once per frame. The
// conductivities, which change with every pass, are not included.
#pragma once

#include <vector>

#include "ice_ice_baby/samples.h"
#include "particles/neighbours.h"
#include "thermal/adiabatic_mirrors.h"
#include "thermal/conductance_pass.h"

namespace ice_ice_baby {

/// Input of the thermal solver for one frame.
template <class Real>
struct ThermalStep {
  double dt_s = 0.0;                                 ///< simulated
  double air_c = 20.0;                               ///< of the air
  const std::vector<std::uint8_t>* steam = nullptr;  ///< (n) 1 for steam; null: no steam
  const std::vector<Real>* volume = nullptr;         ///< (n) relative to water; null: all 1
  const std::vector<Phase>* phase = nullptr;         ///< (n) for solids; null: there are none

  /// Whether a particle belongs to a solid, which exchanges no heat.
  bool solid(std::size_t i) const { return phase && (*phase)[i] == Phase::kSolid; }
};

template <class Real>
class Conductances {
 public:
  Conductances(const Colliders<Real>& colliders, const ThermalBoundaries<Real>& walls,
               const ConductionLattice& lattice);

  /// Allocates the links of all lists, before measuring them.
  void begin(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
             const ThermalStep<Real>& step);

  /// Computes the links of a range of particles.
  /// @param total_m (n) sum of the link lengths of a particle
  /// @param open_m2 (n) exposed area not covered by links, as a vector pointing inwards
  void measure(const VectorField<Real>& x, const Neighbours<Real>& neighbours, ParticleRange range,
               std::vector<Real>& total_m, VectorField<Real>& open_m2);

  /// Links of a particle in the order of its list, as length divided by scale_m(). Symmetric.
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
  std::vector<Real> presence_;      ///< (n) relative volume; 0 for steam
  PackedXyzw<Real> rows_;           ///< (n, 4) x_i and presence
};

}  // namespace ice_ice_baby
