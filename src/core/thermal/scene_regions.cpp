#include "thermal/scene_regions.h"

#include <algorithm>

#include "thermal/heated_regions.h"

namespace ice_ice_baby {

SceneRegions::SceneRegions(const std::vector<HeatRegionParams>& regions) : regions_(regions) {
  for (const HeatRegionParams& one : regions) {
    all_.push_back({one.pose(), one.follow_frame.empty()});
  }
}

void SceneRegions::move(std::size_t k, const Posed& pose) {
  Region& one = all_[k];
  one.moved = one.moved || !one.placed || one.pose.position != pose.position ||
              one.pose.rotation != pose.rotation;
  one.pose = pose;
  one.placed = true;
}

void SceneRegions::addFrame(double frame_s) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    if (regions_[k].active && all_[k].placed) all_[k].owed_j += regions_[k].power_w * frame_s;
  }
}

bool SceneRegions::moved() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Region& one) { return one.moved && one.owed_j != 0.0; });
}

template <class Real>
void SceneRegions::advance(const VectorField<Real>& x, const ThermalStep<Real>& step,
                           std::vector<Real>& power_w) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    Region& one = all_[k];
    const HeatedSpace space{regions_[k].shape, regions_[k].size_m, one.pose};
    if (one.owed_j != 0.0 && step.dt_s > 0.0) {
      spreadPower(space, one.owed_j / step.dt_s, x, step, power_w);
    }
    one.owed_j = 0.0;
    one.moved = false;
  }
}

template void SceneRegions::advance(const VectorField<float>&, const ThermalStep<float>&,
                                    std::vector<float>&);
template void SceneRegions::advance(const VectorField<double>&, const ThermalStep<double>&,
                                    std::vector<double>&);

}  // namespace ice_ice_baby
