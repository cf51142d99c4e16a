// The coarse level of the density solve: projects the displacements of a substep so that no node of
// a coarse grid is overfilled, before the iterations correct what is finer than the grid.
//
// Without it the error of a fixed number of iterations grows with the depth of the water. Deposit
// and interpolation are adjoint and the problem is solved one-sidedly (water pushes and never
// pulls), so the projection never adds energy. doc/algorithm.md derives it.
#pragma once

#include <cstdint>
#include <vector>

#include "coarse/coarse_matrix.h"
#include "coarse/free_volume.h"
#include "coarse/one_sided_solver.h"
#include "colliders/wall_load.h"
#include "phase/phases.h"

namespace ice_ice_baby {

/// Water is fast beyond this many displacements by gravity in a substep.
constexpr double kFast_falls = 3.0;

template <class Real>
class DisplacementProjection {
 public:
  /// @param phases what is water, ice and steam, or null where all is water
  DisplacementProjection(const Scene& scene, const Colliders<Real>& colliders,
                         const Phases<Real>* phases);

  /// Changes x* = x + dt v so that no node is overfilled. Velocities stay. Displacements of members
  /// of ice bodies are those of single particles of which IceBodies::conform makes impulses.
  /// @param bodies or null
  /// @param density (n) relative density after the latest iteration
  void project(Particles<Real>& particles, const IceBodies<Real>* bodies,
               const std::vector<Real>& density, const Vec3<Real>& gravity, Real dt);

  /// (n) sum of mu phi, m^2: as DensityConstraint::multiplier, for the pressure.
  const std::vector<Real>& multiplier() const { return multiplier_; }
  /// The next projection starts without a guess.
  void forget() { guess_.clear(); }
  /// Adapts to substeps that are `ratio` times as long.
  void rescale(double ratio);
  void reorder(const std::vector<Index>& order);

  /// Appends what the latest projection did to colliders. Positions and velocities must be those
  /// that it started from.
  void wallLoads(const Particles<Real>& particles, Real dt,
                 std::vector<WallLoad<Real>>& loads) const;

  std::size_t activeNodes() const { return active_.size(); }
  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.multiplier_, self.guess_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles
  void restore(std::size_t particles) const;

 private:
  /// Pressure of the latest substep at one node, for the next one to start from.
  struct Guess {
    std::uint64_t key;
    Real mu;
    template <class Self, class Archive>
    static void exchange(Self& self, Archive& archive) {
      archive(self.key, self.mu);
    }
  };
  void gather(const Particles<Real>& particles, const IceBodies<Real>* bodies,
              const std::vector<Real>& density, const Vec3<Real>& gravity, Real dt);
  void findTouching(const VectorField<Real>& position);
  void hold(const Particles<Real>& particles, const Vec3<Real>& gravity, Real dt);
  bool resolved(Real fall_m) const;
  void deposit();
  void findActive(Real fall);
  bool interior(std::size_t node) const;
  void loadGuess();
  void keepGuess();
  void move(Particles<Real>& particles, Real dt);
  void findShares();
  bool atSurface(std::size_t sorted) const;
  void levelPressure(const Vec3<Real>& gravity, Real dt);
  Real excessAt(Index i) const;
  void levelBodies(Particles<Real>& particles, const IceBodies<Real>& bodies) const;
  Vec3<Real> pushOn(std::size_t sorted) const;
  Vec3<Real> withoutPull(Vec3<Real> push, const Vec3<Real>& flight, std::size_t k,
                         const ObliqueHold<Real>* oblique) const;
  void moveParticle(Particles<Real>& particles, const CoarseRegion<Real>& region, std::size_t k,
                    const ObliqueHold<Real>* oblique, Real dt);

  void addHeldLoads(const Particles<Real>& particles, Real dt,
                    std::vector<WallLoad<Real>>& loads) const;

  const Colliders<Real>& colliders_;
  const Phases<Real>* phases_;
  Real spacing_;
  double particle_kg_;
  CellPasses<Real> passes_ = cellPasses<Real>();
  CoarseGrids<Real> grids_;
  FreeVolume<Real> free_volume_;
  CellParticles<Real> sorted_;
  std::vector<Index> place_;                ///< (n) in the order of the grids, if there is ice
  std::vector<char> touches_;               ///< (n) whether a wall touches the particle
  std::vector<char> pressed_;               ///< (n) whether a wall holds the particle
  std::vector<Index> touching_;             ///< places in the order of water at walls
  std::vector<ObliqueHold<Real>> holds_;    ///< (touching)
  std::vector<ObliqueHold<Real>> oblique_;  ///< by place in the order
  std::vector<Real> deposits_;              ///< (nodes, kDeposits)
  std::vector<Index> active_;
  std::vector<Real> excess_;  ///< (active) room - R, negative where overfilled
  std::vector<Real> fill_;    ///< (active) particles
  CoarseMatrix<Real> matrix_;
  OneSidedSolver<Real> solver_;
  NodeField<Real> mu_;
  std::array<std::vector<Real>, 3> moved_;  ///< (sorted) cells
  std::vector<Real> value_;                 ///< (sorted)
  std::vector<Real> multiplier_;            ///< (n)
  std::vector<Guess> guess_;
  std::vector<Real> scratch_;
  std::vector<Real> share_;  ///< (nodes) of the room around a node that is filled
  std::vector<std::array<double, 2>> surface_;  ///< (grids) sum of pressures at the surface, count
  std::vector<Real> left_;                      ///< (grids) what is left at the surface, 0 or less
};

}  // namespace ice_ice_baby
