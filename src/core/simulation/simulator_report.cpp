// Reports and samples of the state; nothing here changes it.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

template <class Real>
void Simulator<Real>::updateReport() {
  const std::size_t n = particles_.owned();
  double squares = 0.0, of_water = 0.0, heights = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double square = particles_.velocity.at(i).template cast<double>().squaredNorm();
    squares += square;
    fastest = std::max(fastest, square);
    if (solidAt(i)) continue;  // the body counts
    of_water += square;
    heights -= scene_.gravity_m_s2.dot(particles_.position.at(i).template cast<double>());
  }
  const auto error = fluid_->densityError();
  report_.particles = n;
  report_.springs = springs_ ? springs_->size() : 0;
  report_.density_error_mean = error.mean;
  report_.density_error_max = error.max;
  report_.coarse_nodes = fluid_->coarseNodes();
  report_.kinetic_energy_j = 0.5 * mass_kg_ * of_water;
  report_.potential_energy_j = mass_kg_ * heights;
  report_.elastic_energy_j = elasticEnergy_j();
  report_.max_speed_m_s = std::sqrt(fastest);
  report_.rms_speed_m_s = n > 0 ? std::sqrt(squares / double(n)) : 0.0;
  if (phase_change_) phase_change_->addTo(report_);
  if (!bodies()) return;
  bodies()->forEachSolid([&](const IceBody& body) {
    report_.kinetic_energy_j += body.kineticEnergy_j();
    report_.potential_energy_j -= body.mass_kg * scene_.gravity_m_s2.dot(body.pose.centre_m);
  });
}

/// Elastic energy of compressed water and of springs. doc/stability.md shows the energy balance
/// with and without it.
template <class Real>
double Simulator<Real>::elasticEnergy_j() const {
  const double substeps_1_s = scene_.solver.frame_rate_hz * substep_control_.substeps();
  const double energy_j = fluid_->elasticEnergy_j(substeps_1_s);
  if (!springsCorrect()) return energy_j;
  return energy_j + springs_->elasticEnergy_j(particles_.position, 1.0 / substeps_1_s);
}

template <class Real>
Phase Simulator<Real>::phaseAt(std::size_t i) const {
  if (solidAt(i)) return Phase::kSolid;
  if (scene_.thermal.enabled) return phases()->of(i);
  return frozen() ? Phase::kIce : Phase::kWater;
}

template <class Real>
void Simulator<Real>::sample(std::vector<ParticleSample>& out, std::size_t stride) const {
  const std::vector<Index> places = placesById(particles_.id);
  const std::size_t n = places.size();
  stride = std::max<std::size_t>(stride, 1);
  out.resize((n + stride - 1) / stride);
  const double substeps_1_s = scene_.solver.frame_rate_hz * substep_control_.substeps();
  const ThermalSolver<Real>* heat = this->heat();
  const auto& x = particles_.position;
  const auto& v = particles_.velocity;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Index i = places[k * stride];
    const Phase phase = phaseAt(i);
    out[k] = {float(x.x[i]),
              float(x.y[i]),
              float(x.z[i]),
              float(v.x[i]),
              float(v.y[i]),
              float(v.z[i]),
              float(heat ? heat->temperature(i) : report_.temperature_c),
              phase == Phase::kSolid ? 0.0f : float(heat ? heat->iceFraction(i) : strictness_),
              phase == Phase::kSteam ? kSteamDensity : float(fluid_->density()[i]),
              float(fluid_->pressure_pa(i, substeps_1_s)),
              particles_.id[i],
              phase};
  }
}

template <class Real>
void Simulator<Real>::sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const {
  out.clear();
  if (!springs_ || limit == 0) return;
  const auto& all = springs_->all();
  const std::size_t stride = (all.size() + limit - 1) / limit;
  for (std::size_t s = 0; s < all.size(); s += stride) {
    const Vec3<float> a = particles_.position.at(all[s].a).template cast<float>();
    const Vec3<float> b = particles_.position.at(all[s].b).template cast<float>();
    out.push_back({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
  }
}

template <class Real>
std::vector<SolidState> Simulator<Real>::solids() const {
  std::vector<SolidState> all;
  for (Index k = 0; k < scene_.solids.size(); ++k) {
    const Index body = bodies()->bodyOfSolid(k);
    if (body == kNone) continue;
    all.push_back(bodies()->solidState(body));
    all.back().name = scene_.solids[k].name;
  }
  return all;
}

template <class Real>
void Simulator<Real>::sampleRelativeVolumes(std::vector<float>& out) const {
  out.assign(particles_.owned(), 1.0f);
  if (!phase_change_) return;
  const std::vector<Index> places = placesById(particles_.id);
  const std::vector<Real>& volume = phase_change_->phases().relativeVolume();
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = static_cast<float>(volume[places[k]]);
}

template <class Real>
std::vector<StageStats> Simulator<Real>::stages() const {
  std::vector<StageStats> list;
  const bool iterates = scene_.solver.iterations > 0;
  list.push_back(predict_clock_.stats(particles_.bytes()));
  if (fluid_->hasCoarseLevel()) list.push_back(coarse_clock_.stats(fluid_->coarseBytes()));
  list.push_back(neighbours_clock_.stats(neighbours_.bytes()));
  if (springs_ && !heat()) list.push_back(make_springs_clock_.stats(springs_->bytes()));
  if (bodies()) list.push_back(phase_change_->contactsStage());
  if (iterates) {
    list.push_back(fluid_->lambdaStage());
    list.push_back(fluid_->deltaPStage());
  }
  if (!colliders_.empty()) list.push_back(collide_clock_.stats(colliders_.bytes()));
  if (springsCorrect()) list.push_back(correct_springs_clock_.stats(0));
  if (iterates) list.push_back(position_clock_.stats(0));
  if (bodies()) list.push_back(phase_change_->bodiesStage());
  list.push_back(velocity_clock_.stats(0));
  if (fluid_->viscous()) list.push_back(viscosity_clock_.stats(fluid_->viscosityBytes()));
  if (heat()) list.push_back(phase_change_->heatStage());
  if (phase_change_) list.push_back(phase_change_->phasesStage());
  if (vessel_tracker_) list.push_back(vessels_clock_.stats(vessel_tracker_->bytes()));
  if (sources_) list.push_back(sources_clock_.stats(sources_->bytes()));
  if (drains_) list.push_back(drains_clock_.stats(drains_->bytes()));
  list.push_back(report_clock_.stats(0));
  return list;
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
