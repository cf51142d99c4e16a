// Water as the rest of the simulation sees it: its density and pressure, the corrections that keep
// it from being compressed, and its viscosity.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stage_clock.h"
#include "fluid/boundary_density.h"
#include "fluid/density_constraint.h"
#include "fluid/viscosity.h"

namespace ice_ice_baby {

template <class Real>
class Fluid {
 public:
  /// @param colliders must outlive it, as must phases
  /// @param phases what is water, ice and steam, or null where all is water
  Fluid(const Scene& scene, const Colliders<Real>& colliders, const Phases<Real>* phases);
  Fluid(const Fluid&) = delete;
  Fluid& operator=(const Fluid&) = delete;

  /// Begins a substep: moves x* by the part of the latest substep's correction that is expected
  /// again (`solver.warm_start`).
  void beginSubstep(Particles<Real>& particles) { constraint_.warmStart(particles); }

  /// One iteration of Algorithm 1: lambda_i, then delta p_i, of every particle.
  void iterate(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// The two halves of an iteration, for water that is corrected outside of a substep.
  void updateDensity(const Particles<Real>& particles, const Neighbours<Real>& neighbours) {
    constraint_.computeLambda(particles, neighbours);
  }
  void updateCorrections(const Particles<Real>& particles, const Neighbours<Real>& neighbours) {
    constraint_.computeDeltaP(particles, neighbours);
  }

  /// (n) delta p_i of the latest iteration, m. Collisions amend it.
  VectorField<Real>& deltaP() { return constraint_.deltaP(); }
  const VectorField<Real>& deltaP() const { return constraint_.deltaP(); }

  bool viscous() const { return viscosity_.has_value(); }
  /// Smooths velocities (XSPH) over a substep, where the water is viscous.
  void applyViscosity(Particles<Real>& particles, const Neighbours<Real>& neighbours, double dt_s);

  /// The next substep expects nothing of the latest one: for water that was moved in no time.
  void forget() { constraint_.forgetWarmStart(); }
  /// From now on substeps are `ratio` times as long.
  void rescale(double ratio) { constraint_.rescaleWarmStart(ratio); }
  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order) { constraint_.reorder(order); }

  /// (n) rho_i / rho_0 of the latest iteration.
  const std::vector<Real>& density() const { return constraint_.density(); }
  /// Largest of density(); 1 without particles.
  double maxDensity() const;
  /// What the corrections of the latest substep amount to, Pa.
  double pressure_pa(std::size_t i, double substeps_1_s) const {
    return pascal_s2_m2_ * substeps_1_s * substeps_1_s * double(constraint_.multiplier()[i]);
  }
  /// What compressed water gives back, J: a solver that stops after few iterations leaves it as
  /// soft as springs of stiffness p / C, which give back p V C / 2.
  double elasticEnergy_j(double substeps_1_s) const;
  struct DensityError {
    double mean, max;  ///< of max(rho / rho_0 - 1, 0), by the kernel of the solver
  };
  DensityError densityError() const;
  /// Corrections that `solver.max_correction_h` cut short so far.
  std::uint64_t correctionsLimited() const { return constraint_.limited(); }

  StageStats lambdaStage() const;
  StageStats deltaPStage() const { return delta_p_clock_.stats(0); }
  std::size_t viscosityBytes() const { return viscosity_ ? viscosity_->bytes() : 0; }

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.constraint_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles
  void restore(std::size_t particles) { constraint_.restore(particles); }

 private:
  double mass_kg_;       ///< of a particle
  double pascal_s2_m2_;  ///< -rho_0: pressure of a multiplier of 1 m^2 in substeps of 1 s
  std::optional<BoundaryDensity<Real>> boundary_;
  DensityConstraint<Real> constraint_;
  std::optional<Viscosity<Real>> viscosity_;
  StageClock lambda_clock_{"lambda"};
  StageClock delta_p_clock_{"delta_p"};
};

}  // namespace ice_ice_baby
