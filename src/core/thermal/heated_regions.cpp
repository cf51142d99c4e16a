#include "thermal/heated_regions.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

bool holds(const HeatedRegion& region, const Vec3d& point) {
  const Vec3d arm = 2 * (point - region.centre_m);
  if (region.shape == BlockShape::kBox) {
    return (arm.array().abs() <= region.size_m.array()).all();
  }
  return (arm.array() / region.size_m.array()).square().sum() <= 1.0;
}

}  // namespace

template <class Real>
void HeatedRegions::advance(const VectorField<Real>& x, const ThermalStep<Real>& step,
                            std::vector<Real>& power_w) {
  const double dt_s = step.dt_s;
  const auto forEachInside = [&](const HeatedRegion& region, const auto& visit) {
    parallelFor(x.size(), [&](std::size_t i) {
      if (step.solid(i)) return;
      if (holds(region, x.at(i).template cast<double>())) visit(i);
    });
  };
  for (HeatedRegion& region : active_) {
    std::atomic<std::size_t> inside{0};
    forEachInside(region, [&](std::size_t) { inside.fetch_add(1, std::memory_order_relaxed); });
    const double part = dt_s > 0.0 ? std::min(region.duration_s / dt_s, 1.0) : 0.0;
    region.duration_s -= dt_s;
    if (inside == 0) continue;
    const auto each = static_cast<Real>(part * region.power_w / double(inside));
    forEachInside(region, [&](std::size_t i) { power_w[i] += each; });
  }
  active_.erase(std::remove_if(active_.begin(), active_.end(),
                               [](const HeatedRegion& region) { return region.duration_s <= 0.0; }),
                active_.end());
}

template void HeatedRegions::advance(const VectorField<float>&, const ThermalStep<float>&,
                                     std::vector<float>&);
template void HeatedRegions::advance(const VectorField<double>&, const ThermalStep<double>&,
                                     std::vector<double>&);

}  // namespace ice_ice_baby
