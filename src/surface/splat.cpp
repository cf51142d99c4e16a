#include "splat.h"

#include <algorithm>
#include <cmath>

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splat.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Nodes of a row of a block that lie within `half` of a place, both in edges.
struct Span {
  int first, last;
};
inline Span spanOf(float place, float half) {
  return {std::max(0, int(std::ceil(place - half))),
          std::min(SmoothedVolume::kBlock - 1, int(std::floor(place + half)))};
}

void splatBlock(const Splat& in, SmoothedVolume::Block& block) {
  constexpr int kSide = SmoothedVolume::kBlock;
  const hn::CappedTag<float, kSide> d;
  const float per_m = 1 / in.edge_m, reach = in.reach_m * per_m, reach2 = reach * reach;
  const auto none = hn::Zero(d), scale = hn::Set(d, -1 / reach2);
  block.values.fill(0.0f);
  for (const Index i : block.members) {
    const Vec3<float> at = in.positions[i] * per_m - block.low.cast<float>();
    const auto weight = hn::Set(d, in.weights[i]), z = hn::Set(d, at.z());
    const Span along_x = spanOf(at.x(), reach);
    for (int x = along_x.first; x <= along_x.last; ++x) {
      const float dx2 = (float(x) - at.x()) * (float(x) - at.x());
      const Span along_y = spanOf(at.y(), std::sqrt(std::max(reach2 - dx2, 0.0f)));
      for (int y = along_y.first; y <= along_y.last; ++y) {
        const auto beside = hn::Set(d, dx2 + (float(y) - at.y()) * (float(y) - at.y()));
        float* row = &block.values[std::size_t(kSide * (kSide * x + y))];
        for (int k = 0; k < kSide; k += int(hn::MaxLanes(d))) {
          const auto dz = hn::Sub(hn::Iota(d, float(k)), z);
          const auto r2 = hn::MulAdd(dz, dz, beside);
          const auto t = hn::Max(hn::MulAdd(r2, scale, hn::Set(d, 1.0f)), none);
          hn::StoreU(hn::MulAdd(weight, hn::Mul(t, hn::Mul(t, t)), hn::LoadU(d, row + k)), d,
                     row + k);
        }
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

namespace {

HWY_EXPORT(splatBlock);

}  // namespace

void splat(const Splat& particles, SmoothedVolume::Block& block) {
  HWY_DYNAMIC_DISPATCH(splatBlock)(particles, block);
}

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
