// The interface of the density solve: density, pressure, the corrections that keep water
// incompressible, and viscosity.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stage_clock.h"
#include "coarse/displacement_projection.h"
#include "fluid/boundary_density.h"
#include "fluid/density_constraint.h"
#include "fluid/viscosity.h"

namespace ice_ice_baby {

template <class Real>
class Fluid {
 public:
  /// @param colliders must outlive it, like phases
  /// @param phases phase of each particle, or null if all are water
  Fluid(const Scene& scene, const Colliders<Real>& colliders, const Phases<Real>* phases);
  Fluid(const Fluid&) = delete;
  Fluid& operator=(const Fluid&) = delete;

  /// Starts a substep: moves x* by the fraction `solver.warm_start` of the latest correction.
  void beginSubstep(Particles<Real>& particles) { constraint_.warmStart(particles); }

  bool hasCoarseLevel() const { return coarse_.has_value(); }
  /// Corrects x* for what is coarser than the support radius, at a cost that hardly depends on the
  /// depth of the water.
  /// @param bodies rigid ice, or null
  void projectCoarse(Particles<Real>& particles, const IceBodies<Real>* bodies,
                     const Vec3<Real>& gravity, Real dt) {
    coarse_->project(particles, bodies, density(), gravity, dt);
  }

  /// One iteration of Algorithm 1: lambda_i, then delta p_i, of every particle.
  void iterate(const Particles<Real>& particles, const Neighbours<Real>& neighbours);

  /// The two halves of an iteration, for water that is corrected outside of a substep.
  void updateDensity(const Particles<Real>& particles, const Neighbours<Real>& neighbours) {
    constraint_.computeLambda(particles, neighbours);
  }
  void updateCorrections(const Particles<Real>& particles, const Neighbours<Real>& neighbours) {
    constraint_.computeDeltaP(particles, neighbours);
  }

  /// (n) delta p_i of the latest iteration, m. The collision response changes it.
  VectorField<Real>& deltaP() { return constraint_.deltaP(); }
  const VectorField<Real>& deltaP() const { return constraint_.deltaP(); }

  /// Appends what the coarse level did to colliders in this substep.
  void coarseLoads(const Particles<Real>& particles, Real dt,
                   std::vector<WallLoad<Real>>& loads) const {
    if (coarse_) coarse_->wallLoads(particles, dt, loads);
  }
  /// Calls visit(i, collider, correction) for the part of delta p_i, m, that the density of a
  /// collider causes in the latest iteration. @param predicted x* of that iteration
  template <class Visit>
  void forEachWallCorrection(const VectorField<Real>& predicted, const Visit& visit) const {
    if (!boundary_) return;
    boundary_->forEachPart(
        predicted, [&](std::size_t i, std::size_t collider, const WallSample<Real>& wall) {
          visit(i, collider, Vec3<Real>(constraint_.lambda()[i] * wall.gradient));
        });
  }

  bool viscous() const { return viscosity_.has_value(); }
  /// Smooths velocities (XSPH) over a substep, if the water is viscous.
  void applyViscosity(Particles<Real>& particles, const Neighbours<Real>& neighbours, double dt_s);

  /// Starts the next substep without corrections of the latest one, after water was displaced.
  void forget();
  /// Adapts to substeps that are `ratio` times as long from now on.
  void rescale(double ratio);
  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  /// (n) rho_i / rho_0 of the latest iteration.
  const std::vector<Real>& density() const { return constraint_.density(); }
  /// Largest of density(); 1 without particles.
  double maxDensity() const;
  /// Pressure equivalent to the corrections of the latest substep, Pa.
  double pressure_pa(std::size_t i, double substeps_1_s) const {
    return pascal_s2_m2_ * substeps_1_s * substeps_1_s * multiplier(i);
  }
  /// Energy stored in compressed water, J. After few iterations water is as soft as springs of
  /// stiffness p / C, which store p V C / 2.
  double elasticEnergy_j(double substeps_1_s) const;
  struct DensityError {
    double mean, max;  ///< of max(rho / rho_0 - 1, 0), with the solver's kernel
  };
  DensityError densityError() const;
  /// Number of corrections limited by `solver.max_correction_h` so far.
  std::uint64_t correctionsLimited() const { return constraint_.limited(); }

  StageStats lambdaStage() const;
  StageStats deltaPStage() const { return delta_p_clock_.stats(0); }
  std::size_t coarseNodes() const { return coarse_ ? coarse_->activeNodes() : 0; }
  std::size_t coarseBytes() const { return coarse_ ? coarse_->bytes() : 0; }
  std::size_t viscosityBytes() const { return viscosity_ ? viscosity_->bytes() : 0; }

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.constraint_);
    if (self.coarse_) archive(*self.coarse_);
  }
  /// @throws InvalidInput if the state of a checkpoint does not match the number of particles
  void restore(std::size_t particles);

 private:
  /// Of all levels, m^2.
  double multiplier(std::size_t i) const {
    return double(constraint_.multiplier()[i]) + (coarse_ ? double(coarse_->multiplier()[i]) : 0.0);
  }

  double mass_kg_;       ///< of a particle
  double pascal_s2_m2_;  ///< -rho_0: pressure for a multiplier of 1 m^2 and substeps of 1 s
  std::optional<BoundaryDensity<Real>> boundary_;
  DensityConstraint<Real> constraint_;
  std::optional<DisplacementProjection<Real>> coarse_;
  std::optional<Viscosity<Real>> viscosity_;
  StageClock lambda_clock_{"lambda"};
  StageClock delta_p_clock_{"delta_p"};
};

}  // namespace ice_ice_baby
