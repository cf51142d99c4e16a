#include "thermal/heated_regions.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace ice_ice_baby {

bool HeatedSpace::holds(const Vec3d& point) const {
  const Vec3d arm = 2 * pose.toLocal(point);
  if (shape == BlockShape::kBox) return (arm.array().abs() <= size_m.array()).all();
  return (arm.array() / size_m.array()).square().sum() <= 1.0;
}

template <class Real>
void spreadPower(const HeatedSpace& space, double watts, const VectorField<Real>& x,
                 const ThermalStep<Real>& step, std::vector<Real>& power_w) {
  const auto forEachInside = [&](const auto& visit) {
    parallelFor(x.size(), [&](std::size_t i) {
      if (step.solid(i)) return;
      if (space.holds(x.at(i).template cast<double>())) visit(i);
    });
  };
  std::atomic<std::size_t> inside{0};
  forEachInside([&](std::size_t) { inside.fetch_add(1, std::memory_order_relaxed); });
  if (inside == 0) return;
  const auto each = static_cast<Real>(watts / double(inside));
  forEachInside([&](std::size_t i) { power_w[i] += each; });
}

template <class Real>
void HeatedRegions::advance(const VectorField<Real>& x, const ThermalStep<Real>& step,
                            std::vector<Real>& power_w) {
  for (HeatedRegion& region : active_) {
    const double part = step.dt_s > 0.0 ? std::min(region.duration_s / step.dt_s, 1.0) : 0.0;
    region.duration_s -= step.dt_s;
    const Posed pose{region.centre_m, Mat3<double>::Identity()};
    spreadPower({region.shape, region.size_m, pose}, part * region.power_w, x, step, power_w);
  }
  active_.erase(std::remove_if(active_.begin(), active_.end(),
                               [](const HeatedRegion& region) { return region.duration_s <= 0.0; }),
                active_.end());
}

template void spreadPower(const HeatedSpace&, double, const VectorField<float>&,
                          const ThermalStep<float>&, std::vector<float>&);
template void spreadPower(const HeatedSpace&, double, const VectorField<double>&,
                          const ThermalStep<double>&, std::vector<double>&);
template void HeatedRegions::advance(const VectorField<float>&, const ThermalStep<float>&,
                                     std::vector<float>&);
template void HeatedRegions::advance(const VectorField<double>&, const ThermalStep<double>&,
                                     std::vector<double>&);

}  // namespace ice_ice_baby
