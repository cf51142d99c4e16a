// The inner loops of the neighbour search, as vectors as wide as the processor has.
#pragma once

#include <array>

#include "ice_ice_baby/particles.h"

namespace ice_ice_baby {

/// Particles first ... last - 1.
struct IndexRange {
  Index first, last;
};

/// Particles in the three by three rows of cells, each three cells long, around a cell.
using CellRows = std::array<IndexRange, 9>;

template <class Real>
struct NearSearch {
  /// Writes every j of the rows with |x_j - x_i|^2 < limit2 but i itself, in order, and up to a
  /// vector (16 values) of anything behind the last. Returns the end.
  /// @param padded reaches a vector beyond the last particle
  Index* (*collect)(const VectorField<Real>& padded, Index i, const CellRows& rows, Real limit2,
                    Index* out);
  /// Whether every particle is within `limit` of where it was, but for a shift common to all.
  /// No, if one is not a finite number.
  bool (*allWithin)(const VectorField<Real>& now, const VectorField<Real>& before, Real limit);
};

/// The loops for this processor.
template <class Real>
NearSearch<Real> nearSearch();

}  // namespace ice_ice_baby
