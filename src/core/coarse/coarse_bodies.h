// Rigid ice in the coarse level: a body moves as one, so its part of the normal matrix has rank
// six.
#pragma once

#include <vector>

#include "coarse/coarse_grids.h"
#include "ice/ice_bodies.h"

namespace ice_ice_baby {

template <class Real>
class CoarseBodies {
 public:
  /// What a unit pressure at each active node does to each body: force and torque.
  /// @param bodies or null. Bodies that are held have no part
  /// @param place (n) place of each particle in the order of the grids; kNone: in no cell
  /// @param row_of (nodes) number among the active nodes, or kNone
  void assemble(const IceBodies<Real>* bodies, const Particles<Real>& particles, double particle_kg,
                const CoarseGrids<Real>& grids, const CellParticles<Real>& sorted,
                const std::vector<Index>& place, const std::vector<Index>& row_of,
                std::size_t rows);

  /// y += A x for the part of the bodies. @param x at nodes @param y (active)
  void addProduct(const std::vector<Index>& active, const Real* x, std::vector<Real>& y) const;
  /// Adds the diagonal of the same.
  void addDiagonal(std::vector<Real>& diagonal) const;

  std::size_t bytes() const { return pushes_.capacity() * sizeof(Push); }

 private:
  struct Push {
    Index row;
    Vec3d force, torque;  ///< in units of a particle and a cell
  };
  struct Body {
    std::size_t first, last;        ///< pushes
    double mobility;                ///< 1 / mass in particles of water
    Mat3<double> angular_mobility;  ///< inverse of the moment of inertia, world axes
  };
  void addMember(const CoarseGrid<Real>& grid, const CellParticles<Real>& sorted, std::size_t k,
                 std::size_t lowest, const Vec3d& arm, const std::vector<Index>& row_of);

  std::vector<Body> bodies_;
  std::vector<Push> pushes_;
  std::vector<Index> push_of_;  ///< (active) scratch
};

}  // namespace ice_ice_baby
