#include "flow/sources.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

Sources::Sources(const Scene& scene) {
  for (const Source& source : scene.sources) {
    Outlet outlet(source, scene.fluid.spacing_m);
    std::vector<char> none(outlet.sites.size(), false);
    outflows_.push_back({std::move(outlet), 0.0, std::move(none)});
  }
}

const std::vector<Drop>& Sources::advance(const Scene& scene, std::size_t k, double dt_s,
                                          double room) {
  drops_.clear();
  const Source& source = scene.sources[k];
  if (!source.open) return drops_;
  auto& [outlet, progress, waiting] = outflows_[k];
  const double layers_1_s = source.flowInForce_m3_s() / outlet.layer_m3;
  const Vec3d velocity_m_s = source.speedInForce_m_s() * outlet.direction;
  for (std::size_t s = 0; s < waiting.size() && double(waiting.size()) <= room; ++s) {
    if (waiting[s]) drops_.push_back({s, true, outlet.sites[s], outlet.sites[s], velocity_m_s});
  }
  const double due = progress + layers_1_s * dt_s;
  progress = due - std::floor(due);
  for (double layer = 1.0; layer <= due; ++layer) {
    if (double(drops_.size() + outlet.sites.size()) > room) break;
    emit(outlet, velocity_m_s, scene.gravity_m_s2, (due - layer) / layers_1_s, dt_s);
  }
  for (const Drop& drop : drops_) {
    if (drop.waited) waiting[drop.site] = false;
  }
  return drops_;
}

/// Gravity acts as in a substep, which adds it to the velocity first, so that a layer that starts
/// between two substeps keeps its distance from those that start with one.
void Sources::emit(const Outlet& outlet, const Vec3d& velocity_m_s, const Vec3d& gravity_m_s2,
                   double age_s, double dt_s) {
  const Vec3d way_m = age_s * (velocity_m_s + gravity_m_s2 * (age_s + dt_s) / 2);
  const Vec3d now_m_s = velocity_m_s + gravity_m_s2 * age_s;
  for (std::size_t s = 0; s < outlet.sites.size(); ++s) {
    drops_.push_back({s, false, outlet.sites[s], outlet.sites[s] + way_m, now_m_s});
  }
}

bool Sources::keep(std::size_t k, const Drop& drop) {
  char& waits = outflows_[k].waiting[drop.site];
  const bool lost = waits;
  waits = true;
  return lost;
}

std::size_t Sources::stopped(const Scene& scene, double room) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < outflows_.size(); ++k) {
    count += scene.sources[k].open && double(outflows_[k].waiting.size()) > room;
  }
  return count;
}

std::size_t Sources::bytes() const {
  std::size_t bytes = outflows_.capacity() * sizeof(Outflow) + drops_.capacity() * sizeof(Drop);
  for (const Outflow& one : outflows_) {
    bytes += one.outlet.sites.capacity() * sizeof(Vec3d) + one.waiting.capacity();
  }
  return bytes;
}

bool anyOpen(const std::vector<Source>& sources) {
  return std::any_of(sources.begin(), sources.end(), [](const Source& one) { return one.open; });
}

}  // namespace ice_ice_baby
