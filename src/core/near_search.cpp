#include "ice_ice_baby/near_search.h"

#include <limits>

#include "highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "near_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// No wider than the padding of the fields.
template <class Real>
using Lanes = hn::CappedTag<Real, 16>;

/// A mask over reals as a mask over as many indices.
template <class D, class DIndex>
HWY_INLINE hn::Mask<DIndex> indexMask(D d, DIndex d_index, hn::Mask<D> mask) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(Index)) {
    return hn::RebindMask(d_index, mask);
  } else {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return hn::LoadMaskBits(d_index, bits);
  }
}

template <class D>
HWY_INLINE hn::Vec<D> squaredNorm(D, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> z) {
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

template <class Real>
Index* collect(const VectorField<Real>& padded, Index i, const CellRows& rows, Real limit2,
               Index* out) {
  const Lanes<Real> d;
  const hn::Rebind<Index, Lanes<Real>> d_index;
  constexpr Index kLanes = hn::MaxLanes(d);
  const Real *x = padded.x.data(), *y = padded.y.data(), *z = padded.z.data();
  const auto own_x = hn::Set(d, x[i]), own_y = hn::Set(d, y[i]), own_z = hn::Set(d, z[i]);
  const auto limit = hn::Set(d, limit2);
  const auto own = hn::Set(d_index, i);
  for (const IndexRange& row : rows) {
    const auto last = hn::Set(d_index, row.last);
    for (Index j = row.first; j < row.last; j += kLanes) {
      const auto r2 =
          squaredNorm(d, hn::Sub(hn::LoadU(d, x + j), own_x), hn::Sub(hn::LoadU(d, y + j), own_y),
                      hn::Sub(hn::LoadU(d, z + j), own_z));
      const auto indices = hn::Iota(d_index, j);
      const auto other = hn::And(hn::Lt(indices, last), hn::Ne(indices, own));
      const auto near = hn::And(other, indexMask(d, d_index, hn::Lt(r2, limit)));
      // Compressing in a register and storing all of it is many times faster on some processors
      // than storing compressed.
      hn::StoreU(hn::Compress(indices, near), d_index, out);
      out += hn::CountTrue(d_index, near);
    }
  }
  return out;
}

/// Calls work(i) so that vectors from every such i cover 0 ... n - 1, the last two overlapping.
template <std::size_t kLanes, class Work>
HWY_INLINE bool coverAll(std::size_t n, const Work& work) {
  for (std::size_t i = 0; i + kLanes <= n; i += kLanes) {
    if (!work(i)) return false;
  }
  return n % kLanes == 0 || work(n - kLanes);
}

/// Middle of the displacements along one axis.
template <class D, class Real>
HWY_INLINE Real middleShift(D d, const std::vector<Real>& now, const std::vector<Real>& before) {
  auto low = hn::Set(d, std::numeric_limits<Real>::max());
  auto high = hn::Set(d, std::numeric_limits<Real>::lowest());
  coverAll<hn::MaxLanes(d)>(now.size(), [&](std::size_t i) HWY_ATTR {
    const auto moved = hn::Sub(hn::LoadU(d, &now[i]), hn::LoadU(d, &before[i]));
    low = hn::Min(low, moved);
    high = hn::Max(high, moved);
    return true;
  });
  return (hn::GetLane(hn::MinOfLanes(d, low)) + hn::GetLane(hn::MaxOfLanes(d, high))) / 2;
}

template <class D, class Real>
HWY_INLINE bool allWithinLanes(D d, const VectorField<Real>& now, const VectorField<Real>& before,
                               Real limit) {
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  const auto shift_x = hn::Set(d, middleShift(d, now.x, before.x));
  const auto shift_y = hn::Set(d, middleShift(d, now.y, before.y));
  const auto shift_z = hn::Set(d, middleShift(d, now.z, before.z));
  const auto limit2 = hn::Set(d, limit * limit);
  return coverAll<kLanes>(now.size(), [&](std::size_t i) HWY_ATTR {
    const auto x = hn::Sub(hn::LoadU(d, &now.x[i]), hn::LoadU(d, &before.x[i]));
    const auto y = hn::Sub(hn::LoadU(d, &now.y[i]), hn::LoadU(d, &before.y[i]));
    const auto z = hn::Sub(hn::LoadU(d, &now.z[i]), hn::LoadU(d, &before.z[i]));
    const auto moved2 =
        squaredNorm(d, hn::Sub(x, shift_x), hn::Sub(y, shift_y), hn::Sub(z, shift_z));
    return hn::AllTrue(d, hn::Le(moved2, limit2));  // false for NaN
  });
}

template <class Real>
bool allWithin(const VectorField<Real>& now, const VectorField<Real>& before, Real limit) {
  const Lanes<Real> d;
  if (now.size() >= hn::MaxLanes(d)) return allWithinLanes(d, now, before, limit);
  return allWithinLanes(hn::CappedTag<Real, 1>(), now, before, limit);
}

NearSearch<float> floatSearch() { return {&collect<float>, &allWithin<float>}; }
NearSearch<double> doubleSearch() { return {&collect<double>, &allWithin<double>}; }

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

HWY_EXPORT(floatSearch);
HWY_EXPORT(doubleSearch);

template <>
NearSearch<float> nearSearch() {
  return HWY_DYNAMIC_DISPATCH(floatSearch)();
}
template <>
NearSearch<double> nearSearch() {
  return HWY_DYNAMIC_DISPATCH(doubleSearch)();
}

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
