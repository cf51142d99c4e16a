#include "fluid/fluid.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

template <class Real>
std::optional<BoundaryDensity<Real>> boundaryOf(const Scene& scene,
                                                const Colliders<Real>& colliders) {
  if (!scene.fluid.boundary_density || colliders.empty()) return std::nullopt;
  const double volume_m3 = particleVolume_m3(scene.fluid, scene.supportRadius_m());
  return BoundaryDensity<Real>(scene, colliders, volume_m3);
}

}  // namespace

template <class Real>
Fluid<Real>::Fluid(const Scene& scene, const Colliders<Real>& colliders, const Phases<Real>* phases)
    : mass_kg_(particleMass_kg(scene.fluid, scene.supportRadius_m())),
      pascal_s2_m2_(-scene.fluid.rest_density_kg_m3),
      boundary_(boundaryOf(scene, colliders)),
      constraint_(scene, boundary_ ? &*boundary_ : nullptr, phases) {
  // Without colliders nothing carries water, so it has no depth.
  if (scene.solver.coarse_level && scene.solver.iterations > 0 && !colliders.empty()) {
    coarse_.emplace(scene, colliders, phases);
  }
  if (scene.solver.viscosity_1_s > 0.0 || phases) {
    viscosity_.emplace(scene, particleVolume_m3(scene.fluid, scene.supportRadius_m()), phases);
  }
}

template <class Real>
void Fluid<Real>::iterate(const Particles<Real>& particles, const Neighbours<Real>& neighbours) {
  lambda_clock_.run([&] { constraint_.computeLambda(particles, neighbours); });
  delta_p_clock_.run([&] { constraint_.computeDeltaP(particles, neighbours); });
}

template <class Real>
void Fluid<Real>::applyViscosity(Particles<Real>& particles, const Neighbours<Real>& neighbours,
                                 double dt_s) {
  viscosity_->apply(particles, neighbours, dt_s, constraint_.rows(), maxDensity());
}

template <class Real>
void Fluid<Real>::forget() {
  constraint_.forgetWarmStart();
  if (coarse_) coarse_->forget();
}

template <class Real>
void Fluid<Real>::rescale(double ratio) {
  constraint_.rescaleWarmStart(ratio);
  if (coarse_) coarse_->rescale(ratio);
}

template <class Real>
void Fluid<Real>::reorder(const std::vector<Index>& order) {
  constraint_.reorder(order);
  if (coarse_) coarse_->reorder(order);
}

template <class Real>
double Fluid<Real>::maxDensity() const {
  const auto densest = std::max_element(density().begin(), density().end());
  return densest != density().end() ? double(*densest) : 1.0;
}

template <class Real>
double Fluid<Real>::elasticEnergy_j(double substeps_1_s) const {
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < density().size(); ++i) {
    sum_m2 -= multiplier(i) * std::max(0.0, double(density()[i]) - 1.0);
  }
  return 0.5 * mass_kg_ * sum_m2 * substeps_1_s * substeps_1_s;
}

/// Summed in order.
template <class Real>
typename Fluid<Real>::DensityError Fluid<Real>::densityError() const {
  DensityError error{0.0, 0.0};
  for (const Real relative : density()) {
    const double excess = std::max(0.0, double(relative) - 1.0);
    error.mean += excess;
    error.max = std::max(error.max, excess);
  }
  if (!density().empty()) error.mean /= double(density().size());
  return error;
}

template <class Real>
StageStats Fluid<Real>::lambdaStage() const {
  return lambda_clock_.stats(constraint_.bytes() + (boundary_ ? boundary_->bytes() : 0));
}

template class Fluid<float>;
template class Fluid<double>;

}  // namespace ice_ice_baby
