#include "thermal/conductance_pass.h"

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "thermal/conductance_pass.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/packed_load-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

/// 4 - 6 q for q < 1/2, and 2 (1 - q)^2 / q beyond.
template <class D>
HWY_INLINE hn::Vec<D> cubicSlope(D d, hn::Vec<D> q) {
  using Real = hn::TFromD<D>;
  const auto u = hn::Sub(hn::Set(d, Real(1)), q);
  const auto inner = hn::NegMulAdd(hn::Set(d, Real(6)), q, hn::Set(d, Real(4)));
  const auto outer = hn::Div(hn::Mul(hn::Add(u, u), u), q);
  return hn::IfThenElse(hn::Lt(q, hn::Set(d, Real(0.5))), inner, outer);
}

template <class Real>
void measureLinks(const PairInput<Real>& in, ConductanceSums<Real> out, ParticleRange range) {
  const Lanes<Real> d;
  const auto inverse_h2 = hn::Set(d, 1 / (in.support * in.support));
  const auto one = hn::Set(d, Real(1));
  for (std::size_t i = range.first; i < range.last; ++i) {
    const Real* row = in.positions + 4 * i;
    const auto x = hn::Set(d, row[0]), y = hn::Set(d, row[1]), z = hn::Set(d, row[2]);
    const auto own = hn::Set(d, row[3]);
    auto total = hn::Zero(d), arm_x = total, arm_y = total, arm_z = total;
    const auto list = in.neighbours.of(i);
    Real* links = out.links.data() + out.start[i];
    for (std::size_t k = 0; k < list.size(); k += hn::MaxLanes(d)) {
      const auto kept = hn::FirstN(d, list.size() - k);
      const Columns<Lanes<Real>> other = loadRows(d, in.positions, list.first + k);
      const auto dx = hn::Sub(other.x, x), dy = hn::Sub(other.y, y), dz = hn::Sub(other.z, z);
      const auto r2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
      const auto square = hn::Mul(r2, inverse_h2);
      const auto within = hn::And(hn::Lt(square, one), hn::Gt(square, hn::Zero(d)));
      const auto full = hn::Mul(hn::Mul(own, other.w), cubicSlope(d, hn::Sqrt(square)));
      const auto link = hn::IfThenElseZero(hn::And(within, kept), full);
      hn::BlendedStore(link, kept, d, links + k);
      total = hn::Add(total, link);
      arm_x = hn::MulAdd(link, dx, arm_x);
      arm_y = hn::MulAdd(link, dy, arm_y);
      arm_z = hn::MulAdd(link, dz, arm_z);
    }
    out.total[i] = hn::GetLane(hn::SumOfLanes(d, total));
    out.arms.x[i] = hn::GetLane(hn::SumOfLanes(d, arm_x));
    out.arms.y[i] = hn::GetLane(hn::SumOfLanes(d, arm_y));
    out.arms.z[i] = hn::GetLane(hn::SumOfLanes(d, arm_z));
  }
}

ConductancePass<float> floatLinkPass() { return &measureLinks<float>; }
ConductancePass<double> doubleLinkPass() { return &measureLinks<double>; }

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

HWY_EXPORT(floatLinkPass);
HWY_EXPORT(doubleLinkPass);

template <>
ConductancePass<float> conductancePass<float>() {
  return HWY_DYNAMIC_DISPATCH(floatLinkPass)();
}
template <>
ConductancePass<double> conductancePass<double>() {
  return HWY_DYNAMIC_DISPATCH(doubleLinkPass)();
}

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
