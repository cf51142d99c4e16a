// Vectorised inner loops of the neighbour search.
#pragma once

#include <array>

#include "particles/particles.h"

namespace ice_ice_baby {

/// Particles first ... last - 1.
struct IndexRange {
  Index first, last;
};

/// Index ranges of the 3 x 3 rows of cells around a cell; each row is three cells long.
using CellRows = std::array<IndexRange, 9>;

/// Particles that may be near those of one cell, stored contiguously so that all particles of the
/// cell scan them from the cache.
template <class Real>
struct Candidates {
  std::vector<Real> x, y, z;  ///< m; padded with infinity to a multiple of the vector length
  std::vector<Index> index;
  std::size_t count = 0;

  /// Makes room for this many particles and two vectors.
  void makeRoom(std::size_t particles);
  std::size_t bytes() const {
    return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real) +
           index.capacity() * sizeof(Index);
  }
};

template <class Real>
struct NearSearch {
  /// Collects, in order, the particles of the rows whose squared distance to the bounding box of
  /// the particles `cell` is less than `limit2`.
  /// @param padded positions, padded by one vector beyond the last particle
  /// @param out needs room for all of them
  void (*gather)(const VectorField<Real>& padded, IndexRange cell, const CellRows& rows,
                 Real limit2, Candidates<Real>& out);
  /// Writes every candidate j != i with |x_j - x_i|^2 < limit2, in order. May write up to one
  /// vector (16 values) of garbage after the last. Returns the end.
  /// @param coincident set if one of them has exactly the position of i
  Index* (*collect)(const Candidates<Real>& candidates, const VectorField<Real>& padded, Index i,
                    Real limit2, Index* out, bool& coincident);
  /// Whether every particle has moved less than `limit`, apart from a displacement common to all.
  /// False if a position is not finite.
  bool (*allWithin)(const VectorField<Real>& now, const VectorField<Real>& before, Real limit);
};

/// The loops for the best instruction set of this processor.
template <class Real>
NearSearch<Real> nearSearch();

}  // namespace ice_ice_baby
