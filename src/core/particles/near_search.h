// The inner loops of the neighbour search, as vectors as wide as the processor has.
#pragma once

#include <array>

#include "particles/particles.h"

namespace ice_ice_baby {

/// Particles first ... last - 1.
struct IndexRange {
  Index first, last;
};

/// Particles in the three by three rows of cells, each three cells long, around a cell.
using CellRows = std::array<IndexRange, 9>;

/// Particles that may be near those of one cell, side by side, so that all of the cell scan them
/// from the cache.
template <class Real>
struct Candidates {
  std::vector<Real> x, y, z;  ///< m; from `count` to the next multiple of a vector: infinity
  std::vector<Index> index;
  std::size_t count = 0;

  /// For so many particles and two vectors.
  void makeRoom(std::size_t particles);
  std::size_t bytes() const {
    return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real) +
           index.capacity() * sizeof(Index);
  }
};

template <class Real>
struct NearSearch {
  /// Takes every particle of the rows that is nearer than the root of `limit2` to the box around
  /// particles `cell`, in order.
  /// @param padded reaches a vector beyond the last particle
  /// @param out has room for all of them
  void (*gather)(const VectorField<Real>& padded, IndexRange cell, const CellRows& rows,
                 Real limit2, Candidates<Real>& out);
  /// Writes every candidate j with |x_j - x_i|^2 < limit2 but i itself, in order, and up to a
  /// vector (16 values) of anything behind the last. Returns the end.
  /// @param coincident set if one of them lies exactly where i does
  Index* (*collect)(const Candidates<Real>& candidates, const VectorField<Real>& padded, Index i,
                    Real limit2, Index* out, bool& coincident);
  /// Whether every particle is within `limit` of where it was, but for a shift common to all.
  /// No, if one is not a finite number.
  bool (*allWithin)(const VectorField<Real>& now, const VectorField<Real>& before, Real limit);
};

/// The loops for this processor.
template <class Real>
NearSearch<Real> nearSearch();

}  // namespace ice_ice_baby
