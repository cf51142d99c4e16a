#include "flow/sources.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

Sources::Sources(const Scene& scene) {
  for (const Source& source : scene.sources) {
    Outlet outlet(source, scene.fluid.spacing_m);
    std::vector<char> none(outlet.sites.size(), false);
    outflows_.push_back({std::move(outlet), 0.0, std::move(none), OutletMotion(source)});
  }
}

void Sources::beginFrame(const Scene& scene, double max_m) {
  for (std::size_t k = 0; k < outflows_.size(); ++k) {
    outflows_[k].motion.jump(scene.sources[k].radius_m, max_m);
  }
}

void Sources::setSubstep(double begin, double end) {
  begin_ = begin;
  end_ = end;
}

void Sources::endFrame() {
  for (Outflow& one : outflows_) one.motion.endFrame();
}

const std::vector<Drop>& Sources::advance(const Scene& scene, std::size_t k, double dt_s,
                                          double room) {
  drops_.clear();
  const Source& source = scene.sources[k];
  auto& [outlet, progress, waiting, motion] = outflows_[k];
  if (!source.open || !motion.placed()) return drops_;
  if (double(waiting.size()) <= room) addWaiting(scene, k);
  const double layers_1_s = source.flowInForce_m3_s() / outlet.layer_m3;
  const double due = progress + layers_1_s * dt_s;
  progress = due - std::floor(due);
  for (double layer = 1.0; layer <= due; ++layer) {
    if (double(drops_.size() + outlet.sites.size()) > room) break;
    emit(scene, k, (due - layer) / layers_1_s, dt_s);
  }
  for (const Drop& drop : drops_) {
    if (drop.waited) waiting[drop.site] = false;
  }
  return drops_;
}

void Sources::addWaiting(const Scene& scene, std::size_t k) {
  const auto& [outlet, progress, waiting, motion] = outflows_[k];
  const Posed before = motion.at(begin_), now = motion.at(end_);
  const Vec3d flow_m_s = scene.sources[k].speedInForce_m_s() * now.rotation.col(2);
  for (std::size_t s = 0; s < waiting.size(); ++s) {
    if (!waiting[s]) continue;
    const Vec3d site_m = now.toWorld(outlet.sites[s]);
    const Vec3d outlet_m_s = motion.velocityAt(site_m, now, 1.0 / scene.solver.frame_rate_hz);
    drops_.push_back(
        {s, true, before.toWorld(outlet.sites[s]), site_m, site_m, flow_m_s + outlet_m_s});
  }
}

/// Adds a layer that came out `age_s` ago. Gravity acts as in a substep, which adds it to the
/// velocity first, so that a layer that starts between two substeps keeps its distance from those
/// that start with one.
void Sources::emit(const Scene& scene, std::size_t k, double age_s, double dt_s) {
  const auto& [outlet, progress, waiting, motion] = outflows_[k];
  const double frame_rate_hz = scene.solver.frame_rate_hz;
  const Posed before = motion.at(begin_), now = motion.at(end_);
  const Posed then = motion.at(end_ - age_s * frame_rate_hz);
  const Vec3d flow_m_s = scene.sources[k].speedInForce_m_s() * then.rotation.col(2);
  const Vec3d& gravity_m_s2 = scene.gravity_m_s2;
  for (std::size_t s = 0; s < outlet.sites.size(); ++s) {
    const Vec3d& site = outlet.sites[s];
    const Vec3d start_m = then.toWorld(site);
    const Vec3d start_m_s = flow_m_s + motion.velocityAt(start_m, then, 1.0 / frame_rate_hz);
    const Vec3d way_m = age_s * (start_m_s + gravity_m_s2 * (age_s + dt_s) / 2);
    drops_.push_back({s, false, before.toWorld(site), now.toWorld(site), start_m + way_m,
                      start_m_s + gravity_m_s2 * age_s});
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
