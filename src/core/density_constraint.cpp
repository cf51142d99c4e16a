#include "ice_ice_baby/density_constraint.h"

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/parallel.h"

namespace ice_ice_baby {

namespace {

/// The constraint over one kernel pair.
template <class Real, class Kernels>
class Solver final : public DensityConstraint<Real> {
 public:
  Solver(const Scene& scene, const WallDensity<Real>* walls)
      : kernels_(static_cast<Real>(scene.supportRadius_m())), walls_(walls) {
    const double h = scene.supportRadius_m();
    const FluidParams& fluid = scene.fluid;
    volume_ = static_cast<Real>(particleMass_kg(fluid, h) / fluid.rest_density_kg_m3);
    self_ = fluid.self_density ? volume_ * kernels_.density.w(0) : Real(0);
    relaxation_ = static_cast<Real>(scene.solver.relaxation);
    epsilon_ = static_cast<Real>(scene.solver.epsilon / (h * h));
    resist_tension_ = scene.solver.resist_tension;
    max_correction_ = static_cast<Real>(scene.solver.max_correction_h * h);
  }

  void computeLambda(const Particles<Real>& particles,
                     const Neighbours<Real>& neighbours) override {
    this->resize(particles.size());
    if (walls_) this->wall_gradient_.resize(particles.size());
    parallelFor(particles.size(), [&](std::size_t i) { lambdaOf(i, particles, neighbours); });
  }

  void computeDeltaP(const Particles<Real>& particles,
                     const Neighbours<Real>& neighbours) override {
    parallelFor(particles.size(), [&](std::size_t i) { deltaPOf(i, particles, neighbours); });
  }

 private:
  void lambdaOf(std::size_t i, const Particles<Real>& particles,
                const Neighbours<Real>& neighbours) {
    const VectorField<Real>& x = particles.predicted;
    const Vec3<Real> xi = x.at(i);
    const Real h2 = kernels_.density.h * kernels_.density.h;
    Real density = 0, sum_squares = 0;
    Vec3<Real> own = Vec3<Real>::Zero();
    for (const Index j : neighbours.of(i)) {
      const Vec3<Real> r = xi - x.at(j);
      const Real r2 = r.squaredNorm();
      if (r2 >= h2 || r2 == 0) continue;
      const Real distance = std::sqrt(r2);
      density += kernels_.density.w(distance);
      const Real slope = volume_ * kernels_.gradient.slope(distance);
      sum_squares += slope * slope;   // |grad_j C_i|^2, Eq. 4 for a neighbour
      own += r * (slope / distance);  // grad_i C_i, Eq. 4 for itself
    }
    Real relative = self_ + volume_ * density;
    if (walls_) {
      const WallSample<Real> wall = walls_->at(xi);
      relative += wall.value;
      own += wall.gradient;
      this->wall_gradient_.set(i, wall.gradient);
    }
    this->density_[i] = relative;
    Real constraint = relative - this->restDensity(i);  // Eq. 2
    if (!resist_tension_) constraint = std::max(constraint, Real(0));
    const Real gradients = sum_squares + own.squaredNorm() + epsilon_;
    this->lambda_[i] = gradients > 0 ? -relaxation_ * constraint / gradients : Real(0);  // Eq. 5
  }

  void deltaPOf(std::size_t i, const Particles<Real>& particles,
                const Neighbours<Real>& neighbours) {
    const VectorField<Real>& x = particles.predicted;
    const Vec3<Real> xi = x.at(i);
    const Real h2 = kernels_.density.h * kernels_.density.h;
    const Real lambda = this->lambda_[i];
    Vec3<Real> sum = Vec3<Real>::Zero();
    for (const Index j : neighbours.of(i)) {
      const Real both = lambda + this->lambda_[j];
      const Vec3<Real> r = xi - x.at(j);
      const Real r2 = r.squaredNorm();
      if (both == 0 || r2 >= h2 || r2 == 0) continue;
      const Real distance = std::sqrt(r2);
      sum += r * (both * kernels_.gradient.slope(distance) / distance);  // Eq. 6
    }
    sum *= volume_;
    // A wall mirrors the particle's own lambda: it presses back as water would.
    if (walls_) sum += 2 * lambda * this->wall_gradient_.at(i);
    const Real length = sum.norm();
    if (max_correction_ > 0 && length > max_correction_) sum *= max_correction_ / length;
    this->delta_p_.set(i, sum);
  }

  Kernels kernels_;
  const WallDensity<Real>* walls_;
  Real volume_;
  Real self_;
  Real relaxation_;
  Real epsilon_;
  bool resist_tension_;
  Real max_correction_;
};

}  // namespace

template <class Real>
void DensityConstraint<Real>::resize(std::size_t n) {
  density_.resize(n);
  lambda_.resize(n);
  delta_p_.resize(n);
}

template <class Real>
void DensityConstraint<Real>::keepDensity() {
  kept_density_ = density_;
  for (Real& density : kept_density_) density = std::max(density, Real(1));
}

template <class Real>
void DensityConstraint<Real>::renumber(const std::vector<Index>& order) {
  if (!kept_density_.empty()) permute(kept_density_, order);
}

template <class Real>
std::size_t DensityConstraint<Real>::bytes() const {
  return (density_.capacity() + lambda_.capacity() + kept_density_.capacity()) * sizeof(Real) +
         delta_p_.bytes() + wall_gradient_.bytes();
}

template <class Real>
std::unique_ptr<DensityConstraint<Real>> makeDensityConstraint(const Scene& scene,
                                                               const WallDensity<Real>* walls) {
  if (scene.fluid.kernel == KernelPair::kCubic) {
    return std::make_unique<Solver<Real, CubicPair<Real>>>(scene, walls);
  }
  return std::make_unique<Solver<Real, Poly6SpikyPair<Real>>>(scene, walls);
}

template class DensityConstraint<float>;
template class DensityConstraint<double>;
template std::unique_ptr<DensityConstraint<float>> makeDensityConstraint(const Scene&,
                                                                         const WallDensity<float>*);
template std::unique_ptr<DensityConstraint<double>> makeDensityConstraint(
    const Scene&, const WallDensity<double>*);

}  // namespace ice_ice_baby
