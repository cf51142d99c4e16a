// What the vessels and gauges of the scene hold, and what flows into and out of them.
#include <algorithm>
#include <cmath>

#include "simulation/simulator.h"

namespace ice_ice_baby {

template <class Real>
void Simulator<Real>::countFlows(bool on) {
  const bool any = !(scene_.containers.empty() && scene_.cups.empty() && scene_.gauges.empty());
  if (!on || !any) return vessel_tracker_.reset();
  if (vessel_tracker_) return;
  arena_.execute(
      [&] { vessel_tracker_.emplace(scene_, particles_, colliders_, solidIds(), report_.time_s); });
}

/// Counts who has entered and left each vessel since the last call.
template <class Real>
void Simulator<Real>::observeVessels() {
  if (!vessel_tracker_) return;
  arena_.execute(
      [&] { vessels_clock_.run([&] { vessel_tracker_->observe(particles_, colliders_); }); });
}

/// Sums run in particle order, so they have the same bits for any number of threads.
template <class Real>
std::vector<VesselContent> Simulator<Real>::vesselContents(const MeasuredVessels& vessels) const {
  std::vector<VesselContent> contents(vessels.size());
  std::vector<VesselNumber> where;
  for (std::size_t group = 0; group < vessels.groups(); ++group) {
    arena_.execute([&] { vessels.locate(group, particles_.position, colliders_, where); });
    for (std::size_t i = 0; i < particles_.owned(); ++i) {
      if (where[i] == kNoVessel) continue;
      VesselContent& content = contents[where[i]];
      const Phase phase = phaseAt(i);
      const double volume = phases() ? double(phases()->relativeVolume()[i]) : 1;
      if (phase == Phase::kSolid) {
        const IceBody& body = bodies()->body(bodies()->bodyOf(Index(i)));
        content.floating += std::min(volume, body.mass_particles / double(body.count()));
        continue;
      }
      ++content.particles;
      content.steam += phase == Phase::kSteam;
      content.water += phase == Phase::kWater ? volume : 0.0;
      content.ice += phase == Phase::kIce ? volume : 0.0;
      content.celsius += heat() ? heat()->temperature(i) : 0.0;
    }
  }
  return contents;
}

template <class Real>
std::vector<VesselReport> Simulator<Real>::vessels() const {
  const MeasuredVessels vessels(scene_);
  const std::vector<VesselContent> contents = vesselContents(vessels);
  const double particle_m3 = std::pow(scene_.fluid.spacing_m, 3);
  const double gravity_m_s2 = scene_.gravity_m_s2.norm();
  std::vector<VesselReport> reports(vessels.size());
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const VesselContent& content = contents[k];
    VesselReport& report = reports[k];
    report.name = vessels[k].name;
    report.particles = content.particles;
    report.water_m3 = content.water * particle_m3;
    report.ice_m3 = content.ice * particle_m3;
    report.level_m = std::numeric_limits<double>::quiet_NaN();
    if (gravity_m_s2 > 0.0) {
      const double liquid_m3 =
          (double(content.particles - content.steam) + content.floating) * particle_m3;
      const Vec3d up = -scene_.gravity_m_s2 / gravity_m_s2;
      report.level_m = vessels.level_m(k, up, liquid_m3, colliders_);
    }
    if (heat() && content.particles > 0) {
      report.mean_celsius = content.celsius / double(content.particles);
    }
    if (vessel_tracker_) addFlows(k, particle_m3, report);
  }
  return reports;
}

template <class Real>
void Simulator<Real>::addFlows(std::size_t vessel, double particle_m3, VesselReport& report) const {
  const auto& totals = vessel_tracker_->totals(vessel);
  const auto rates = vessel_tracker_->rates(vessel);
  report.inflow_m3_s = rates.in_1_s * particle_m3;
  report.outflow_m3_s = rates.out_1_s * particle_m3;
  report.entered_m3 = double(totals.entered) * particle_m3;
  report.left_m3 = double(totals.left) * particle_m3;
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
