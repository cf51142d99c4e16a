// What a simulator tells of its state; nothing here changes it.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

std::vector<Index> placesById(const std::vector<std::uint32_t>& ids) {
  std::vector<Index> places(ids.size());
  for (Index k = 0; k < ids.size(); ++k) places[ids[k]] = k;
  return places;
}

/// Of densities relative to rest, summed in order.
template <class Real>
Simulation::DensityError densityError(const std::vector<Real>& density) {
  Simulation::DensityError error;
  for (const Real relative : density) {
    const double excess = std::max(0.0, double(relative) - 1.0);
    error.mean += excess;
    error.max = std::max(error.max, excess);
    error.volume_lost += excess / (1.0 + excess);
  }
  if (density.empty()) return error;
  error.mean /= double(density.size());
  error.volume_lost /= double(density.size());
  return error;
}

}  // namespace

template <class Real>
void Simulator<Real>::updateReport() {
  const std::size_t n = particles_.size();
  double squares = 0.0, heights = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double square = particles_.velocity.at(i).template cast<double>().squaredNorm();
    squares += square;
    fastest = std::max(fastest, square);
    heights -= scene_.gravity_m_s2.dot(particles_.position.at(i).template cast<double>());
  }
  const auto error = fluid_->densityError();
  report_.particles = n;
  report_.springs = springs_ ? springs_->size() : 0;
  report_.density_error_mean = error.mean;
  report_.density_error_max = error.max;
  report_.kinetic_energy_j = 0.5 * mass_kg_ * squares;
  report_.potential_energy_j = mass_kg_ * heights;
  report_.elastic_energy_j = elasticEnergy_j();
  report_.max_speed_m_s = std::sqrt(fastest);
  report_.rms_speed_m_s = n > 0 ? std::sqrt(squares / double(n)) : 0.0;
  if (heat_) reportHeat();
}

/// Of compressed water and of springs. doc/stability.md shows the balance with and without.
template <class Real>
double Simulator<Real>::elasticEnergy_j() const {
  const double substeps_1_s = scene_.solver.frame_rate_hz * substeps_;
  const double energy_j = fluid_->elasticEnergy_j(substeps_1_s);
  if (!springsCorrect()) return energy_j;
  return energy_j + springs_->elasticEnergy_j(particles_.position, 1.0 / substeps_1_s);
}

template <class Real>
void Simulator<Real>::sample(std::vector<ParticleSample>& out, std::size_t stride) const {
  const std::vector<Index> places = placesById(particles_.id);
  const std::size_t n = places.size();
  stride = std::max<std::size_t>(stride, 1);
  out.resize((n + stride - 1) / stride);
  const double substeps_1_s = scene_.solver.frame_rate_hz * substeps_;
  const auto& x = particles_.position;
  const auto& v = particles_.velocity;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Index i = places[k * stride];
    out[k] = {float(x.x[i]),
              float(x.y[i]),
              float(x.z[i]),
              float(v.x[i]),
              float(v.y[i]),
              float(v.z[i]),
              float(heat_ ? heat_->temperature(i) : report_.temperature_c),
              float(heat_ ? heat_->iceFraction(i) : strictness_),
              float(fluid_->density()[i]),
              float(fluid_->pressure_pa(i, substeps_1_s)),
              std::uint32_t(k * stride)};
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
Simulation::DensityError Simulator<Real>::measureDensityError() {
  const Real h = static_cast<Real>(2 * scene_.fluid.spacing_m);
  const CubicSpline<Real> kernel(h);
  const double volume = 1.0 / latticeSum(CubicSpline<double>(h), scene_.fluid.spacing_m, true);
  if (!reference_boundary_) {
    Scene yardstick = scene_;
    yardstick.fluid.kernel = KernelPair::kCubic;
    yardstick.fluid.support_radius_m = 0.0;
    reference_boundary_.emplace(yardstick, colliders_, volume);
  }
  std::vector<Real> density(particles_.size());
  arena_.execute([&] {
    Neighbours<Real> fresh(h, 0);
    VectorField<Real> sorted = particles_.position;
    const std::vector<Index> order = fresh.sortOrder(particles_.position);
    permute(sorted, order, density);
    fresh.build(sorted);
    std::vector<Real> share(sorted.size(), Real(1));
    if (phases_)
      std::transform(order.begin(), order.end(), share.begin(),
                     [&](Index i) { return phases_->share()[i]; });
    parallelFor(sorted.size(), [&](std::size_t i) {
      const Vec3<Real> xi = sorted.at(i);
      density[i] = 0;
      if (share[i] == 0) return;  // steam has no density to keep
      Real sum = share[i] * kernel.w(0);
      for (const Index j : fresh.of(i)) sum += share[j] * kernel.w((xi - sorted.at(j)).norm());
      density[i] = static_cast<Real>(volume) * sum + reference_boundary_->at(xi).value;
    });
  });
  return densityError(density);
}

template <class Real>
std::size_t Simulator<Real>::countEscaped() const {
  const std::vector<Index> places = placesById(particles_.id);
  std::size_t escaped = 0;
  for (std::size_t k = 0; k < spawns_.size(); ++k) {
    const Block& block = scene_.blocks[k];
    const Vec3<Real> centre = ((block.min_m + block.max_m) / 2).cast<Real>();
    for (std::size_t c = 0; c < scene_.containers.size(); ++c) {
      const auto& body = colliders_.containers[c];
      const Pose<Real> start = scene_.containers[c].pose().cast<Real>();
      if (body.shape.open_top || !body.shape.inside(start.toLocal(centre))) continue;
      for (std::uint32_t id = spawns_[k].first_id; id < spawns_[k].first_id + spawns_[k].count;
           ++id) {
        const Vec3<Real> local = body.motion.to.toLocal(particles_.position.at(places[id]));
        if (!body.shape.inside(local)) ++escaped;
      }
    }
  }
  return escaped;
}

template <class Real>
std::vector<StageStats> Simulator<Real>::stages() const {
  std::vector<StageStats> list;
  const bool iterates = scene_.solver.iterations > 0;
  list.push_back(predict_clock_.stats(particles_.bytes()));
  list.push_back(neighbours_clock_.stats(neighbours_.bytes()));
  if (springs_ && !heat_) list.push_back(make_springs_clock_.stats(springs_->bytes()));
  if (bodies_) list.push_back(contacts_clock_.stats(contacts_->bytes()));
  if (iterates) {
    list.push_back(fluid_->lambdaStage());
    list.push_back(fluid_->deltaPStage());
  }
  if (!colliders_.empty()) list.push_back(collide_clock_.stats(colliders_.bytes()));
  if (springsCorrect()) list.push_back(correct_springs_clock_.stats(0));
  if (iterates) list.push_back(position_clock_.stats(0));
  if (bodies_) list.push_back(bodies_clock_.stats(bodies_->bytes()));
  list.push_back(velocity_clock_.stats(0));
  if (fluid_->viscous()) list.push_back(viscosity_clock_.stats(fluid_->viscosityBytes()));
  if (heat_) list.push_back(heat_clock_.stats(heat_->bytes()));
  if (phases_) {
    list.push_back(phases_clock_.stats(phases_->bytes() + (springs_ ? springs_->bytes() : 0)));
  }
  list.push_back(report_clock_.stats(0));
  return list;
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
