// Loads the rows of four values of several particles as one vector per column.
//
// Included once per instruction set, hence the guard that Highway toggles.
#if defined(IIB_PACKED_LOAD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef IIB_PACKED_LOAD_INL_H
#undef IIB_PACKED_LOAD_INL_H
#else
#define IIB_PACKED_LOAD_INL_H
#endif

#include <hwy/highway.h>

#include "ice_ice_baby/types.h"

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most 16 lanes, the padding of neighbour lists.
template <class Real>
using Lanes = hn::CappedTag<Real, 16>;

/// One vector per column of the rows.
template <class D>
struct Columns {
  hn::Vec<D> x, y, z, w;
};

#if HWY_TARGET == HWY_SCALAR

template <class D, class Real>
HWY_INLINE Columns<D> loadRows(D d, const Real* rows, const Index* j) {
  const Real* row = rows + 4 * std::size_t(*j);
  return {hn::Set(d, row[0]), hn::Set(d, row[1]), hn::Set(d, row[2]), hn::Set(d, row[3])};
}

#else

/// Gathers 16-byte blocks: block k comes from column + 4 * j[k * lanes per block].
template <class D, class Real>
HWY_INLINE hn::Vec<D> loadBlocks(D d, const Real* column, const Index* j) {
  if constexpr (hn::MaxLanes(d) * sizeof(Real) <= 16) {
    return hn::LoadU(d, column + 4 * std::size_t(*j));
  } else {
    const hn::Half<D> half;
    const auto low = loadBlocks(half, column, j);
    const auto high = loadBlocks(half, column, j + hn::MaxLanes(half));
    return hn::Combine(d, high, low);
  }
}

/// Rows j[0], j[1], ... as columns. Transposing within each block was faster than gathers on every
/// processor tried.
template <class D>
HWY_INLINE Columns<D> loadRows(D d, const float* rows, const Index* j) {
  const auto row0 = loadBlocks(d, rows, j);
  const auto row1 = loadBlocks(d, rows, j + 1);
  const auto row2 = loadBlocks(d, rows, j + 2);
  const auto row3 = loadBlocks(d, rows, j + 3);
  const auto even_xy = hn::InterleaveLower(d, row0, row2);
  const auto odd_xy = hn::InterleaveLower(d, row1, row3);
  const auto even_zw = hn::InterleaveUpper(d, row0, row2);
  const auto odd_zw = hn::InterleaveUpper(d, row1, row3);
  return {hn::InterleaveLower(d, even_xy, odd_xy), hn::InterleaveUpper(d, even_xy, odd_xy),
          hn::InterleaveLower(d, even_zw, odd_zw), hn::InterleaveUpper(d, even_zw, odd_zw)};
}

template <class D>
HWY_INLINE Columns<D> loadRows(D d, const double* rows, const Index* j) {
  const auto even_xy = loadBlocks(d, rows, j);
  const auto odd_xy = loadBlocks(d, rows, j + 1);
  const auto even_zw = loadBlocks(d, rows + 2, j);
  const auto odd_zw = loadBlocks(d, rows + 2, j + 1);
  return {hn::InterleaveLower(d, even_xy, odd_xy), hn::InterleaveUpper(d, even_xy, odd_xy),
          hn::InterleaveLower(d, even_zw, odd_zw), hn::InterleaveUpper(d, even_zw, odd_zw)};
}

#endif

/// values[j[0]], values[j[1]], ...
template <class D>
HWY_INLINE hn::Vec<D> loadEach(D d, const float* values, const Index* j) {
  const hn::RebindToSigned<D> places;
  const hn::RebindToUnsigned<D> indices;
  return hn::GatherIndex(d, values, hn::BitCast(places, hn::LoadU(indices, j)));
}

template <class D>
HWY_INLINE hn::Vec<D> loadEach(D d, const double* values, const Index* j) {
  const hn::RebindToSigned<D> places;
  const hn::RebindToUnsigned<D> wide;
  const hn::Rebind<Index, D> indices;
  return hn::GatherIndex(d, values,
                         hn::BitCast(places, hn::PromoteTo(wide, hn::LoadU(indices, j))));
}

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#endif
