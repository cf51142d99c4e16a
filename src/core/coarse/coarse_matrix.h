// The normal matrix of the coarse level at its active nodes: what a change of pressure at one node
// changes in the water around another.
#pragma once

#include <vector>

#include "coarse/coarse_bodies.h"
#include "coarse/coarse_grids.h"
#include "coarse/held_particles.h"

namespace ice_ice_baby {

/// Values at all nodes with zeros before and after; see CoarseGrids::nodePadding.
template <class Real>
class NodeField {
 public:
  void reset(std::size_t nodes, std::size_t padding) {
    padding_ = padding;
    values_.assign(nodes + 2 * padding, Real(0));
  }
  void resetLike(const NodeField& other) {
    padding_ = other.padding_;
    values_.assign(other.values_.size(), Real(0));
  }
  Real* data() { return values_.data() + padding_; }
  const Real* data() const { return values_.data() + padding_; }
  Real& operator[](std::size_t node) { return values_[padding_ + node]; }
  Real operator[](std::size_t node) const { return values_[padding_ + node]; }
  std::size_t bytes() const { return values_.capacity() * sizeof(Real); }

 private:
  std::size_t padding_ = 0;
  std::vector<Real> values_;
};

template <class Real>
class CoarseMatrix {
 public:
  /// A = sum over the particles of v^2 grad phi_a . F grad phi_b for active nodes a; F leaves the
  /// directions that are free. Members of ice bodies are left to addBodies.
  /// @param active ascending numbers of nodes
  void assemble(const CoarseGrids<Real>& grids, const CellPasses<Real>& passes,
                const CellParticles<Real>& particles, const std::vector<ObliqueHold<Real>>& oblique,
                const std::vector<Index>& active);

  /// The part of rigid ice, after assemble. See CoarseBodies::assemble. Nodes inside ice, where a
  /// pressure moves nothing, get a diagonal of 0.
  /// @param fill (active) volume of all particles at the node, in particles
  void addBodies(const IceBodies<Real>* bodies, const Particles<Real>& particles,
                 double particle_kg, const CoarseGrids<Real>& grids,
                 const CellParticles<Real>& sorted, const std::vector<Index>& place,
                 const std::vector<Real>& fill);

  /// y = A x. @param x at nodes, 0 where inactive. @param y (active)
  void multiply(const NodeField<Real>& x, std::vector<Real>& y) const;
  /// (active)
  Real diagonal(std::size_t row) const { return diagonal_[row]; }

  std::size_t rows() const { return active_.size(); }
  /// Rows for which there is memory.
  std::size_t maxRows() const { return max_rows_; }
  std::size_t bytes() const {
    return (rows_.capacity() + diagonal_.capacity()) * sizeof(Real) +
           row_of_.capacity() * sizeof(Index) + bodies_.bytes();
  }

 private:
  static constexpr std::size_t kStencil = 125;
  void addCell(const CoarseGrid<Real>& grid, std::size_t lowest, const Real* pairs);
  void addOblique(const CoarseGrid<Real>& grid, std::size_t lowest,
                  const CellParticles<Real>& particles, const ObliqueHold<Real>& hold);
  bool anyActive(const CoarseGrid<Real>& grid, std::size_t lowest) const;

  std::size_t max_rows_ = 0;
  std::vector<Index> active_;
  std::vector<std::array<std::ptrdiff_t, 2>> strides_;  ///< (active) of its grid, x and y
  std::vector<Index> row_of_;                           ///< (nodes) kNone: inactive
  std::vector<Real> diagonal_;                          ///< (active)
  CoarseBodies<Real> bodies_;
  std::vector<Real> rows_;  ///< (active, 5, 5, 5) by the offset of the other node
};

}  // namespace ice_ice_baby
