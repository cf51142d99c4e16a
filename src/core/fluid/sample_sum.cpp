#include "fluid/sample_sum.h"

#include <cmath>

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fluid/sample_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/packed_load-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

double sumSamples(const Vec3d& at, bool inside, const SampleInput& in) {
  const Lanes<float> d;
  const hn::RebindToSigned<decltype(d)> places;
  const SampleColumns& s = in.samples;
  const auto x = hn::Set(d, float(at.x())), y = hn::Set(d, float(at.y())),
             z = hn::Set(d, float(at.z()));
  const auto per_m2 = hn::Set(d, in.per_m2), size = hn::Set(d, in.size), none = hn::Zero(d);
  const float* with = inside ? s.behind.data() : s.ahead.data();
  const float* against = inside ? s.ahead.data() : s.behind.data();
  auto sum = none;
  for (std::size_t k = 0; k < s.x.size(); k += hn::MaxLanes(d)) {
    const auto dx = hn::Sub(x, hn::LoadU(d, &s.x[k])), dy = hn::Sub(y, hn::LoadU(d, &s.y[k])),
               dz = hn::Sub(z, hn::LoadU(d, &s.z[k]));
    const auto square = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    const auto place = hn::Min(hn::Mul(square, per_m2), size);
    const auto facing =
        hn::MulAdd(dx, hn::LoadU(d, &s.nx[k]),
                   hn::MulAdd(dy, hn::LoadU(d, &s.ny[k]), hn::Mul(dz, hn::LoadU(d, &s.nz[k]))));
    const auto seen = hn::Mul(facing, hn::GatherIndex(d, in.table, hn::ConvertTo(places, place)));
    sum = hn::MulAdd(hn::Max(seen, none), hn::LoadU(d, with + k), sum);
    sum = hn::MulAdd(hn::Min(seen, none), hn::LoadU(d, against + k), sum);
  }
  const double total = double(hn::GetLane(hn::SumOfLanes(d, sum)));
  return inside ? -total : total;
}

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

namespace {

constexpr int kSize = 4096;

HWY_EXPORT(sumSamples);

}  // namespace

void SampleColumns::add(const SurfaceSample& sample, bool closed) {
  const auto to = [](std::vector<float>& column, double value) { column.push_back(float(value)); };
  to(x, sample.point.x());
  to(y, sample.point.y());
  to(z, sample.point.z());
  const Vec3d normal = sample.area_m2 * sample.normal;
  to(nx, normal.x());
  to(ny, normal.y());
  to(nz, normal.z());
  // Whoever looks along the normal leaves the solid here, unless the wall hides what lies behind.
  const double leaves = 1 - sample.opacity;
  if (closed) {
    to(ahead, 1.0);
    to(behind, leaves);
    return;
  }
  // An open surface has no inside: its wall is what lies between two sheets, or a single sheet.
  to(ahead, sample.covered_ahead ? -leaves : sample.covered_behind ? 1.0 : sample.opacity);
  to(behind, sample.covered_behind ? leaves : sample.covered_ahead ? -1.0 : -sample.opacity);
}

void SampleColumns::pad() {
  for (std::vector<float>* column : {&x, &y, &z, &nx, &ny, &nz, &ahead, &behind}) {
    column->resize((column->size() + kLanes - 1) / kLanes * kLanes, 0.0f);
  }
}

SampleKernel::SampleKernel(const WallKernel& kernel)
    : per_m2_(float(kSize / (kernel.reach_m() * kernel.reach_m()))) {
  for (int k = 0; k < kSize; ++k) {
    const double r = kernel.reach_m() * std::sqrt((k + 0.5) / kSize);
    table_.push_back(float(kernel.beyond(r) / (r * r * r)));
  }
  table_.push_back(0.0f);
}

double SampleKernel::sum(const Vec3d& x, bool inside, const SampleColumns& samples) const {
  return HWY_DYNAMIC_DISPATCH(sumSamples)(x, inside,
                                          {samples, table_.data(), float(kSize), per_m2_});
}

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
