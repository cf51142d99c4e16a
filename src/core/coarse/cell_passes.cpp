#include "coarse/cell_passes.h"

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "coarse/cell_passes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
using CellLanes = hn::CappedTag<Real, kCellPadding>;

/// Splines of a vector of particles along one axis.
template <class D>
struct Splines {
  hn::Vec<D> value[3], slope[3];
};

template <class D>
HWY_INLINE Splines<D> splines(D d, const hn::TFromD<D>* place) {
  using Real = hn::TFromD<D>;
  const auto u = hn::LoadU(d, place);
  const auto one = hn::Set(d, Real(1)), half = hn::Set(d, Real(0.5));
  const auto rest = hn::Sub(one, u), middle = hn::Sub(u, half);
  Splines<D> s;
  s.value[0] = hn::Mul(half, hn::Mul(rest, rest));
  s.value[1] = hn::NegMulAdd(middle, middle, hn::Set(d, Real(0.75)));
  s.value[2] = hn::Mul(half, hn::Mul(u, u));
  s.slope[0] = hn::Neg(rest);
  s.slope[1] = hn::Sub(rest, u);
  s.slope[2] = u;
  return s;
}

/// Loads a vector of values; lanes beyond the cell are 0.
template <class D>
HWY_INLINE hn::Vec<D> loadFirst(D d, const std::vector<hn::TFromD<D>>& values, std::size_t at,
                                std::size_t count) {
  return hn::IfThenElseZero(hn::FirstN(d, count), hn::LoadU(d, values.data() + at));
}

/// Sums each of `count` vectors over its lanes.
template <class D>
HWY_INLINE void sumLanes(D d, const hn::TFromD<D>* sums, std::size_t count, hn::TFromD<D>* out) {
  for (std::size_t k = 0; k < count; ++k) {
    out[k] = hn::GetLane(hn::SumOfLanes(d, hn::Load(d, sums + k * hn::Lanes(d))));
  }
}

template <class Real>
void deposit(const CellParticles<Real>& in, CellRange cell, Real* out) {
  const CellLanes<Real> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  HWY_ALIGN Real sums[kCellNodes * kDeposits * kLanes] = {};
  for (std::size_t k = 0; k < cell.count; k += kLanes) {
    const std::size_t at = cell.first + k, count = cell.count - k;
    const auto x = splines(d, in.place[0].data() + at);
    const auto y = splines(d, in.place[1].data() + at);
    const auto z = splines(d, in.place[2].data() + at);
    const auto volume = loadFirst(d, in.volume, at, count);
    const auto step_x = hn::Mul(volume, hn::LoadU(d, in.step[0].data() + at));
    const auto step_y = hn::Mul(volume, hn::LoadU(d, in.step[1].data() + at));
    const auto step_z = hn::Mul(volume, hn::LoadU(d, in.step[2].data() + at));
    const auto drift2 = hn::LoadU(d, in.drift2.data() + at);
    const auto density = hn::LoadU(d, in.density.data() + at);
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto yz = hn::Mul(y.value[b], z.value[c]);
        const auto along_x = hn::Mul(step_x, yz);
        const auto across = hn::MulAdd(hn::Mul(step_y, y.slope[b]), z.value[c],
                                       hn::Mul(hn::Mul(step_z, y.value[b]), z.slope[c]));
        const auto filled = hn::Mul(volume, yz);
        for (std::size_t a = 0; a < 3; ++a) {
          Real* sum = sums + ((a * 3 + b) * 3 + c) * kDeposits * kLanes;
          const auto flow =
              hn::MulAdd(x.slope[a], along_x, hn::MulAdd(x.value[a], across, hn::Load(d, sum)));
          const auto fill = hn::Mul(filled, x.value[a]);
          hn::Store(flow, d, sum);
          hn::Store(hn::Add(hn::Load(d, sum + kLanes), fill), d, sum + kLanes);
          hn::Store(hn::MulAdd(fill, drift2, hn::Load(d, sum + 2 * kLanes)), d, sum + 2 * kLanes);
          hn::Store(hn::MulAdd(fill, density, hn::Load(d, sum + 3 * kLanes)), d, sum + 3 * kLanes);
        }
      }
    }
  }
  sumLanes(d, sums, kCellNodes * kDeposits, out);
}

template <class Real>
void normalMatrix(const CellParticles<Real>& in, CellRange cell, Real* out) {
  const CellLanes<Real> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  HWY_ALIGN Real sums[kCellPairs * kLanes] = {};
  constexpr int kFirst[6] = {0, 0, 0, 1, 1, 2}, kSecond[6] = {0, 1, 2, 1, 2, 2};
  for (std::size_t k = 0; k < cell.count; k += kLanes) {
    const std::size_t at = cell.first + k, count = cell.count - k;
    const auto x = splines(d, in.place[0].data() + at);
    const auto y = splines(d, in.place[1].data() + at);
    const auto z = splines(d, in.place[2].data() + at);
    const auto weight = loadFirst(d, in.weight, at, count);
    const auto free_x = hn::Mul(weight, hn::LoadU(d, in.free[0].data() + at));
    const auto free_y = hn::LoadU(d, in.free[1].data() + at);
    const auto free_z = hn::LoadU(d, in.free[2].data() + at);
    hn::Vec<decltype(d)> xx[6], xx_slope[6], zz[6], zz_slope[6];
    for (int p = 0; p < 6; ++p) {
      xx[p] = hn::Mul(weight, hn::Mul(x.value[kFirst[p]], x.value[kSecond[p]]));
      xx_slope[p] = hn::Mul(free_x, hn::Mul(x.slope[kFirst[p]], x.slope[kSecond[p]]));
      zz[p] = hn::Mul(z.value[kFirst[p]], z.value[kSecond[p]]);
      zz_slope[p] = hn::Mul(free_z, hn::Mul(z.slope[kFirst[p]], z.slope[kSecond[p]]));
    }
    for (int q = 0; q < 6; ++q) {
      const auto yy = hn::Mul(y.value[kFirst[q]], y.value[kSecond[q]]);
      const auto yy_slope = hn::Mul(free_y, hn::Mul(y.slope[kFirst[q]], y.slope[kSecond[q]]));
      for (int r = 0; r < 6; ++r) {
        const auto yz = hn::Mul(yy, zz[r]);
        const auto yz_slope = hn::MulAdd(yy_slope, zz[r], hn::Mul(yy, zz_slope[r]));
        for (int p = 0; p < 6; ++p) {
          Real* sum = sums + std::size_t((p * 6 + q) * 6 + r) * kLanes;
          hn::Store(hn::MulAdd(xx_slope[p], yz, hn::MulAdd(xx[p], yz_slope, hn::Load(d, sum))), d,
                    sum);
        }
      }
    }
  }
  sumLanes(d, sums, kCellPairs, out);
}

template <class Real>
void interpolate(const CellParticles<Real>& in, CellRange cell, const Real* mu,
                 std::array<Real*, 3> slope, Real* value) {
  const CellLanes<Real> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  for (std::size_t k = 0; k < cell.count; k += kLanes) {
    const std::size_t at = cell.first + k;
    const auto x = splines(d, in.place[0].data() + at);
    const auto y = splines(d, in.place[1].data() + at);
    const auto z = splines(d, in.place[2].data() + at);
    auto sum = hn::Zero(d), along_x = sum, along_y = sum, along_z = sum;
    for (std::size_t a = 0; a < 3; ++a) {
      auto plane = hn::Zero(d), plane_y = plane, plane_z = plane;
      for (std::size_t b = 0; b < 3; ++b) {
        auto line = hn::Zero(d), line_z = line;
        for (std::size_t c = 0; c < 3; ++c) {
          const auto node = hn::Set(d, mu[(a * 3 + b) * 3 + c]);
          line = hn::MulAdd(node, z.value[c], line);
          line_z = hn::MulAdd(node, z.slope[c], line_z);
        }
        plane = hn::MulAdd(line, y.value[b], plane);
        plane_y = hn::MulAdd(line, y.slope[b], plane_y);
        plane_z = hn::MulAdd(line_z, y.value[b], plane_z);
      }
      sum = hn::MulAdd(plane, x.value[a], sum);
      along_x = hn::MulAdd(plane, x.slope[a], along_x);
      along_y = hn::MulAdd(plane_y, x.value[a], along_y);
      along_z = hn::MulAdd(plane_z, x.value[a], along_z);
    }
    // Lanes beyond the cell belong to particles of another cell, perhaps of another thread.
    const auto mask = hn::FirstN(d, cell.count - k);
    const auto volume = hn::LoadU(d, in.volume.data() + at);
    const hn::Vec<decltype(d)> along[3] = {along_x, along_y, along_z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hn::BlendedStore(hn::Mul(volume, along[axis]), mask, d, slope[axis] + at);
    }
    hn::BlendedStore(sum, mask, d, value + at);
  }
}

template <class Real>
CellPasses<Real> passesOf() {
  return {&deposit<Real>, &normalMatrix<Real>, &interpolate<Real>};
}

CellPasses<float> floatCellPasses() { return passesOf<float>(); }
CellPasses<double> doubleCellPasses() { return passesOf<double>(); }

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

HWY_EXPORT(floatCellPasses);
HWY_EXPORT(doubleCellPasses);

template <>
CellPasses<float> cellPasses() {
  return HWY_DYNAMIC_DISPATCH(floatCellPasses)();
}
template <>
CellPasses<double> cellPasses() {
  return HWY_DYNAMIC_DISPATCH(doubleCellPasses)();
}

template <class Real>
void CellParticles<Real>::resize(std::size_t n) {
  for (auto* axes : {&place, &step, &free}) {
    for (std::vector<Real>& axis : *axes) axis.resize(n + kCellPadding);
  }
  for (auto* values : {&volume, &weight, &drift2, &density}) values->resize(n + kCellPadding);
}

template <class Real>
std::size_t CellParticles<Real>::bytes() const {
  return 13 * volume.capacity() * sizeof(Real);
}

template struct CellParticles<float>;
template struct CellParticles<double>;

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
