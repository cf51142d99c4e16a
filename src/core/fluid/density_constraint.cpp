#include "fluid/density_constraint.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "particles/kernels.h"
#include "phase/steam.h"

namespace ice_ice_baby {

namespace {

/// Calls visit(run) for maximal runs of selected particles, and leave_out(i) for each of the
/// others.
/// @param wanted (n) 1 for selected particles; null: all
template <class Visit, class LeaveOut>
void forEachRun(ParticleRange range, const std::vector<std::uint8_t>* wanted, const Visit& visit,
                const LeaveOut& leave_out) {
  if (!wanted) return visit(range);
  for (std::size_t i = range.first; i < range.last;) {
    const std::size_t first = i;
    while (i < range.last && (*wanted)[i]) ++i;
    if (i > first) visit(ParticleRange{first, i});
    for (; i < range.last && !(*wanted)[i]; ++i) leave_out(i);
  }
}

}  // namespace

template <class Real>
DensityConstraint<Real>::DensityConstraint(const Scene& scene, const BoundaryDensity<Real>* walls,
                                           const Phases<Real>* phases)
    : walls_(walls),
      phases_(phases),
      passes_(phases ? mixturePairPasses<Real>(scene.fluid.kernel)
                     : pairPasses<Real>(scene.fluid.kernel)) {
  const double h = scene.supportRadius_m();
  const FluidParams& fluid = scene.fluid;
  const double volume = particleVolume_m3(fluid, h);
  support_ = static_cast<Real>(h);
  ice_density_ = static_cast<Real>(scene.ice.density_ratio);
  weight_scale_ = static_cast<Real>(volume * densityAtZero(fluid.kernel, h));
  gradient_scale_ = static_cast<Real>(volume * slopeAtHalf(fluid.kernel, h) / (h / 2));
  self_ = fluid.self_density ? weight_scale_ : Real(0);
  relaxation_ = static_cast<Real>(scene.relaxation());
  epsilon_ = static_cast<Real>(scene.solver.epsilon / (h * h));
  resist_tension_ = scene.solver.resist_tension;
  warm_start_ = static_cast<Real>(scene.solver.warm_start);
  max_correction_ = static_cast<Real>(scene.solver.max_correction_h * h);
}

/// Reuses the corrections rather than lambda: this takes no pass over pairs, and conserves momentum
/// because the corrections of all particles cancel.
template <class Real>
void DensityConstraint<Real>::warmStart(Particles<Real>& particles) {
  resize(particles.size());
  begun_ = false;
  parallelFor(particles.size(), [&](std::size_t i) {
    multiplier_[i] *= warm_start_;
    if (!warmStarts()) return;
    const Vec3<Real> start = warm_start_ * correction_.at(i);
    correction_.set(i, start);
    particles.predicted.add(i, start);
  });
}

template <class Real>
void DensityConstraint<Real>::computeLambda(const Particles<Real>& particles,
                                            const Neighbours<Real>& neighbours) {
  const VectorField<Real>& x = particles.predicted;
  resize(x.size());
  if (phases_) {
    positions_.pack(x, phases_->relativeVolume());
  } else {
    positions_.pack(x);
  }
  const PairInput<Real> pairs{neighbours, positions_.data(), nullptr, support_};
  const auto computeRun = [&](ParticleRange run) {
    passes_.sumConstraint(pairs, {density_, lambda_, delta_p_}, run);
    if (walls_) addWalls(x, run);
    for (std::size_t i = run.first; i < run.last; ++i) finishLambda(i);
  };
  parallelForRanges(x.size(), [&](std::size_t first, std::size_t last) {
    forEachRun({first, last}, phases_ ? &phases_->wet() : nullptr, computeRun,
               [&](std::size_t i) { skipLambda(i); });
  });
}

/// Adds the contribution of walls, scaled like the sums over neighbours.
template <class Real>
void DensityConstraint<Real>::addWalls(const VectorField<Real>& x, ParticleRange range) {
  for (std::size_t i = range.first; i < range.last; ++i) {
    wall_gradient_.set(i, Vec3<Real>::Zero());
  }
  walls_->forEachNear(x, range.first, range.last, [&](std::size_t i, const WallSample<Real>& wall) {
    density_[i] += wall.value / weight_scale_;
    const Vec3<Real> gradient = wall.gradient / gradient_scale_;
    delta_p_.add(i, gradient);
    wall_gradient_.set(i, gradient);
  });
}

/// Converts the sums over neighbours to density and lambda, in place.
template <class Real>
void DensityConstraint<Real>::finishLambda(std::size_t i) {
  const Real own_volume = phases_ ? phases_->relativeVolume()[i] : Real(1);
  const Real relative = self_ * own_volume + weight_scale_ * density_[i];
  const Vec3<Real> own = gradient_scale_ * delta_p_.at(i);  // grad_i C_i, Eq. 4 for itself
  const Real slope_scale = gradient_scale_ * support_;
  const Real others = slope_scale * slope_scale * lambda_[i];  // |grad_j C_i|^2, for a neighbour
  density_[i] = relative;
  const Real constraint = relative - 1;  // Eq. 2
  const Real gradients = others + own.squaredNorm() + epsilon_;
  lambda_[i] = gradients > 0 ? -relaxation_ * constraint / gradients : Real(0);  // Eq. 5
  // Water pushes and never pulls, except that the first iteration may take back the warm start.
  const Real max = begun_ ? Real(0) : -multiplier_[i];
  if (!resist_tension_) lambda_[i] = std::min(lambda_[i], max);
}

/// Ice and steam have no pressure of their own.
template <class Real>
void DensityConstraint<Real>::skipLambda(std::size_t i) {
  density_[i] = phases_->steam(i) ? static_cast<Real>(kSteamDensity) : ice_density_;
  lambda_[i] = 0;
  if (walls_) wall_gradient_.set(i, Vec3<Real>::Zero());
}

template <class Real>
void DensityConstraint<Real>::computeDeltaP(const Particles<Real>& particles,
                                            const Neighbours<Real>& neighbours) {
  positions_.pack(particles.predicted, lambda_);
  PairInput<Real> pairs{neighbours, positions_.data(), nullptr, support_};
  if (phases_) pairs.relative_volumes = phases_->relativeVolume().data();
  const auto computeRun = [&](ParticleRange run) {
    passes_.sumCorrections(pairs, delta_p_, run);
    for (std::size_t i = run.first; i < run.last; ++i) finishDeltaP(i);
  };
  parallelForRanges(particles.size(), [&](std::size_t first, std::size_t last) {
    forEachRun({first, last}, phases_ ? &phases_->pressed() : nullptr, computeRun,
               [&](std::size_t i) { delta_p_.set(i, Vec3<Real>::Zero()); });
  });
  begun_ = true;
}

template <class Real>
void DensityConstraint<Real>::finishDeltaP(std::size_t i) {
  Vec3<Real> sum = delta_p_.at(i);  // Eq. 6
  if (walls_) sum += lambda_[i] * wall_gradient_.at(i);
  sum *= gradient_scale_;
  const Real length2 = sum.squaredNorm();
  if (max_correction_ > 0 && length2 > max_correction_ * max_correction_) {
    sum *= max_correction_ / std::sqrt(length2);
    limited_.fetch_add(1, std::memory_order_relaxed);
  }
  delta_p_.set(i, sum);
  multiplier_[i] += lambda_[i];
  if (warmStarts()) correction_.add(i, sum);
}

template <class Real>
void DensityConstraint<Real>::resize(std::size_t n) {
  density_.resize(n);
  lambda_.resize(n);
  delta_p_.resize(n);
  multiplier_.resize(n);
  if (walls_) wall_gradient_.resize(n);
  if (warmStarts()) correction_.resize(n);
}

template <class Real>
void DensityConstraint<Real>::forgetWarmStart() {
  std::fill(multiplier_.begin(), multiplier_.end(), Real(0));
  for (auto* axis : {&correction_.x, &correction_.y, &correction_.z}) {
    std::fill(axis->begin(), axis->end(), Real(0));
  }
}

template <class Real>
void DensityConstraint<Real>::rescaleWarmStart(double ratio) {
  const Real square = static_cast<Real>(ratio * ratio);  // corrections scale with dt^2
  parallelFor(multiplier_.size(), [&](std::size_t i) {
    multiplier_[i] *= square;
    if (warmStarts()) correction_.set(i, square * correction_.at(i));
  });
}

template <class Real>
void DensityConstraint<Real>::reorder(const std::vector<Index>& order) {
  if (multiplier_.size() < order.size()) resize(order.size());  // what came starts from nothing
  std::vector<Real>& scratch = lambda_;  // recomputed before it is read again
  permute(multiplier_, order, scratch);
  if (warmStarts()) permute(correction_, order, scratch);
  resize(order.size());
}

template <class Real>
std::size_t DensityConstraint<Real>::bytes() const {
  return (density_.capacity() + lambda_.capacity() + multiplier_.capacity()) * sizeof(Real) +
         delta_p_.bytes() + wall_gradient_.bytes() + correction_.bytes() + positions_.bytes();
}

template class DensityConstraint<float>;
template class DensityConstraint<double>;

}  // namespace ice_ice_baby
