// The density constraint of position based fluids: paper Eq. 2-6, Macklin & Mueller 2013.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "fluid/boundary_density.h"
#include "fluid/pair_passes.h"
#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"

namespace ice_ice_baby {

/// Uses volumes instead of masses: with V = m / rho_0, C_i = V sum_j W_ij + walls - 1. In a mixture
/// V is that of each neighbour. Ice and steam have no constraint of their own; steam has no volume.
template <class Real>
class DensityConstraint {
 public:
  /// @param walls density of colliders, or null where the scene has none or leaves it out
  /// @param phases what is water, ice and steam, or null where all is water
  DensityConstraint(const Scene& scene, const BoundaryDensity<Real>* walls,
                    const Phases<Real>* phases = nullptr);

  /// Starts a substep: moves x* by the fraction `solver.warm_start` of the latest correction, so
  /// that the iterations only have to find the change.
  void warmStart(Particles<Real>& particles);

  /// lambda_i of every particle (Eq. 5), times the relaxation.
  void computeLambda(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// Delta p_i of every particle (Eq. 6), limited to the largest correction, and its sum over the
  /// iterations of the substep.
  void computeDeltaP(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// The next substep starts without a warm start.
  void forgetWarmStart();

  /// Rescales the warm start for a substep that is `ratio` times as long.
  void rescaleWarmStart(double ratio);

  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  bool warmStarts() const { return warm_start_ > 0; }
  const VectorField<Real>& deltaP() const { return delta_p_; }
  VectorField<Real>& deltaP() { return delta_p_; }
  /// (n) rho_i / rho_0 of the latest computeLambda.
  const std::vector<Real>& density() const { return density_; }
  const std::vector<Real>& lambda() const { return lambda_; }
  /// Scratch memory of each compute, available to others in between.
  PackedXyzw<Real>& rows() { return positions_; }
  /// (n) sum of lambda over the warm start and the iterations of the latest substep, m^2. The
  /// pressure is -rho_0 / dt^2 times it.
  const std::vector<Real>& multiplier() const { return multiplier_; }

  /// Number of corrections limited by `solver.max_correction_h` so far.
  std::uint64_t limited() const { return limited_; }
  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.density_, self.multiplier_, self.correction_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles
  void restore(std::size_t particles);

 private:
  void resize(std::size_t n);
  void addWalls(const VectorField<Real>& x, ParticleRange range);
  void finishLambda(std::size_t i);
  void skipLambda(std::size_t i);
  void finishDeltaP(std::size_t i);

  const BoundaryDensity<Real>* walls_;
  const Phases<Real>* phases_;
  PairPasses<Real> passes_;
  Real support_;         ///< h, m
  Real ice_density_;     ///< over that of water
  Real weight_scale_;    ///< V W(0): density for a sum of 1
  Real gradient_scale_;  ///< V W'(h/2) / (h/2), 1/m^2: gradient for a sum of 1 m
  Real self_;            ///< contribution of a particle to its own density
  Real relaxation_;
  Real epsilon_;  ///< 1/m^2
  bool resist_tension_;
  Real warm_start_;
  bool begun_ = true;    ///< whether an iteration of this substep has been done
  Real max_correction_;  ///< m; 0: unlimited
  std::atomic<std::uint64_t> limited_{0};
  PackedXyzw<Real> positions_;       ///< (n, 4) x_i* and lambda_i
  std::vector<Real> density_;        ///< (n) rho_i / rho_0
  std::vector<Real> lambda_;         ///< (n) m^2
  VectorField<Real> delta_p_;        ///< (n) m; before that the sums of computeLambda
  VectorField<Real> wall_gradient_;  ///< (n) m, in the scale of the sums; empty without walls
  std::vector<Real> multiplier_;     ///< (n) m^2
  VectorField<Real> correction_;     ///< (n) m, total of the substep; empty without warm start
};

}  // namespace ice_ice_baby
