#include "particles/near_search.h"

#include <algorithm>
#include <limits>

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/near_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most as wide as the padding of the fields.
template <class Real>
using Lanes = hn::CappedTag<Real, 16>;

/// Converts a mask to another lane type with the same number of lanes.
template <class DTo, class DFrom>
HWY_INLINE hn::Mask<DTo> convertMask(DTo to, DFrom from, hn::Mask<DFrom> mask) {
  if constexpr (sizeof(hn::TFromD<DTo>) == sizeof(hn::TFromD<DFrom>)) {
    return hn::RebindMask(to, mask);
  } else {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(from, mask, bits);
    return hn::LoadMaskBits(to, bits);
  }
}

template <class D>
HWY_INLINE hn::Vec<D> squaredNorm(D, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> z) {
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

/// Bounding box of the particles of one cell, its bounds broadcast to vectors.
template <class D>
struct Box {
  hn::Vec<D> low, high;

  template <class Real>
  Box(D d, const std::vector<Real>& axis, IndexRange cell) {
    const auto bounds = std::minmax_element(axis.begin() + cell.first, axis.begin() + cell.last);
    low = hn::Set(d, *bounds.first);
    high = hn::Set(d, *bounds.second);
  }
  /// Distance beyond the box along its axis; 0 inside.
  HWY_INLINE hn::Vec<D> beyond(D d, hn::Vec<D> value) const {
    return hn::Max(hn::Zero(d), hn::Max(hn::Sub(low, value), hn::Sub(value, high)));
  }
};

template <class Real>
void gather(const VectorField<Real>& padded, IndexRange cell, const CellRows& rows, Real limit2,
            Candidates<Real>& out) {
  const Lanes<Real> d;
  const hn::Rebind<Index, Lanes<Real>> d_index;
  constexpr Index kLanes = hn::MaxLanes(d);
  const Box<Lanes<Real>> box_x(d, padded.x, cell), box_y(d, padded.y, cell),
      box_z(d, padded.z, cell);
  const auto limit = hn::Set(d, limit2);
  std::size_t count = 0;
  for (const IndexRange& row : rows) {
    const auto last = hn::Set(d_index, row.last);
    for (Index j = row.first; j < row.last; j += kLanes) {
      const auto x = hn::LoadU(d, &padded.x[j]);
      const auto y = hn::LoadU(d, &padded.y[j]);
      const auto z = hn::LoadU(d, &padded.z[j]);
      const auto r2 = squaredNorm(d, box_x.beyond(d, x), box_y.beyond(d, y), box_z.beyond(d, z));
      const auto indices = hn::Iota(d_index, j);
      const auto inside = hn::Lt(indices, last);
      const auto near = hn::And(convertMask(d, d_index, inside), hn::Lt(r2, limit));
      // On some processors a compressing store is many times slower than compressing in a register
      // and storing all of it.
      hn::StoreU(hn::Compress(x, near), d, &out.x[count]);
      hn::StoreU(hn::Compress(y, near), d, &out.y[count]);
      hn::StoreU(hn::Compress(z, near), d, &out.z[count]);
      hn::StoreU(hn::Compress(indices, convertMask(d_index, d, near)), d_index, &out.index[count]);
      count += hn::CountTrue(d, near);
    }
  }
  hn::StoreU(hn::Inf(d), d, &out.x[count]);
  hn::StoreU(hn::Inf(d), d, &out.y[count]);
  hn::StoreU(hn::Inf(d), d, &out.z[count]);
  out.count = count;
}

template <class Real>
Index* collect(const Candidates<Real>& candidates, const VectorField<Real>& padded, Index i,
               Real limit2, Index* out, bool& coincident) {
  const Lanes<Real> d;
  const hn::Rebind<Index, Lanes<Real>> d_index;
  const auto own_x = hn::Set(d, padded.x[i]);
  const auto own_y = hn::Set(d, padded.y[i]);
  const auto own_z = hn::Set(d, padded.z[i]);
  const auto limit = hn::Set(d, limit2);
  const auto own = hn::Set(d_index, i);
  auto here = hn::Zero(d_index);
  for (std::size_t k = 0; k < candidates.count; k += hn::MaxLanes(d)) {
    const auto r2 = squaredNorm(d, hn::Sub(hn::LoadU(d, &candidates.x[k]), own_x),
                                hn::Sub(hn::LoadU(d, &candidates.y[k]), own_y),
                                hn::Sub(hn::LoadU(d, &candidates.z[k]), own_z));
    const auto indices = hn::LoadU(d_index, &candidates.index[k]);
    const auto other = hn::Ne(indices, own);
    const auto near = hn::And(other, convertMask(d_index, d, hn::Lt(r2, limit)));
    const auto same = hn::And(other, convertMask(d_index, d, hn::Eq(r2, hn::Zero(d))));
    here = hn::Or(here, hn::VecFromMask(d_index, same));
    hn::StoreU(hn::Compress(indices, near), d_index, out);
    out += hn::CountTrue(d_index, near);
  }
  if (!hn::AllTrue(d_index, hn::Eq(here, hn::Zero(d_index)))) coincident = true;
  return out;
}

/// Calls work(i) for vectors that start at i and cover 0 ... n - 1; the last two overlap.
template <std::size_t kLanes, class Work>
HWY_INLINE bool coverAll(std::size_t n, const Work& work) {
  for (std::size_t i = 0; i + kLanes <= n; i += kLanes) {
    if (!work(i)) return false;
  }
  return n % kLanes == 0 || work(n - kLanes);
}

/// Midpoint of the displacements along one axis.
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

NearSearch<float> floatSearch() { return {&gather<float>, &collect<float>, &allWithin<float>}; }
NearSearch<double> doubleSearch() {
  return {&gather<double>, &collect<double>, &allWithin<double>};
}

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

HWY_EXPORT(floatSearch);
HWY_EXPORT(doubleSearch);

/// Allocates a quarter more than needed, so that a steady state does not allocate.
template <class Real>
void Candidates<Real>::makeRoom(std::size_t particles) {
  constexpr std::size_t kVector = 16;
  if (index.size() >= particles + 2 * kVector) return;
  const std::size_t room = particles + particles / 4 + 2 * kVector;
  for (auto* axis : {&x, &y, &z}) *axis = std::vector<Real>(room);
  index = std::vector<Index>(room);
}

template struct Candidates<float>;
template struct Candidates<double>;

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
