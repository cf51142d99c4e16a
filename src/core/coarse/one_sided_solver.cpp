#include "coarse/one_sided_solver.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

constexpr int kRounds = 4;
constexpr int kMaxIterations = 200;
constexpr double kTolerance = 3e-3;  ///< of the residual, relative to b
constexpr double kRidge = 1e-5;      ///< relative increase of the diagonal
constexpr std::size_t kChunk = 512;  ///< of sums, whose order does not depend on threads

}  // namespace

template <class Real>
double OneSidedSolver<Real>::dot(const std::vector<Real>& a, const std::vector<Real>& b) {
  partial_.reserve(a.capacity() / kChunk + 1);
  partial_.assign((a.size() + kChunk - 1) / kChunk, 0.0);
  parallelFor(
      partial_.size(),
      [&](std::size_t chunk) {
        double sum = 0.0;
        const std::size_t last = std::min(a.size(), (chunk + 1) * kChunk);
        for (std::size_t k = chunk * kChunk; k < last; ++k) sum += double(a[k]) * double(b[k]);
        partial_[chunk] = sum;
      },
      1);
  double sum = 0.0;
  for (const double part : partial_) sum += part;
  return sum;
}

template <class Real>
void OneSidedSolver<Real>::conjugateGradients(const CoarseMatrix<Real>& matrix,
                                              const std::vector<Index>& active,
                                              const std::vector<Real>& b, NodeField<Real>& mu) {
  const std::size_t n = active.size();
  const Real ridge = static_cast<Real>(kRidge);
  const auto preconditioned = [&](std::size_t k) {
    return off_[k] ? Real(0) : residual_[k] / ((1 + ridge) * matrix.diagonal(k));
  };
  matrix.multiply(mu, product_);
  double target = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Real own = ridge * matrix.diagonal(k) * mu[active[k]];
    residual_[k] = off_[k] ? Real(0) : b[k] - product_[k] - own;
    scaled_[k] = preconditioned(k);
    direction_[k] = scaled_[k];
    if (!off_[k]) target += double(b[k]) * double(b[k]) / double(matrix.diagonal(k));
  }
  target *= kTolerance * kTolerance;
  double old = dot(residual_, scaled_);
  while (old > target && iterations_ < kMaxIterations) {
    for (std::size_t k = 0; k < n; ++k) search_[active[k]] = direction_[k];
    matrix.multiply(search_, product_);
    for (std::size_t k = 0; k < n; ++k) {
      product_[k] = off_[k] ? Real(0) : product_[k] + ridge * matrix.diagonal(k) * direction_[k];
    }
    const double curvature = dot(direction_, product_);
    if (!(curvature > 0.0)) break;
    const auto step = static_cast<Real>(old / curvature);
    for (std::size_t k = 0; k < n; ++k) {
      mu[active[k]] += step * direction_[k];
      residual_[k] -= step * product_[k];
      scaled_[k] = preconditioned(k);
    }
    const double now = dot(residual_, scaled_);
    const auto share = static_cast<Real>(now / old);
    for (std::size_t k = 0; k < n; ++k) direction_[k] = scaled_[k] + share * direction_[k];
    old = now;
    ++iterations_;
  }
}

template <class Real>
void OneSidedSolver<Real>::solve(const CoarseMatrix<Real>& matrix, const std::vector<Index>& active,
                                 const std::vector<Real>& b, NodeField<Real>& mu) {
  const std::size_t n = active.size();
  off_.reserve(matrix.maxRows());
  off_.assign(n, false);
  for (auto* values : {&residual_, &scaled_, &product_, &direction_}) {
    values->reserve(matrix.maxRows());
    values->resize(n);
  }
  iterations_ = 0;
  search_.resetLike(mu);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(matrix.diagonal(k) > 0)) off_[k] = true;
    if (off_[k]) mu[active[k]] = 0;
  }
  for (int round = 0; round < kRounds; ++round) {
    conjugateGradients(matrix, active, b, mu);
    bool pulled = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (off_[k] || mu[active[k]] <= 0) continue;
      mu[active[k]] = 0;
      off_[k] = true;
      pulled = true;
    }
    if (!pulled) break;
  }
  matrix.multiply(mu, product_);
  for (std::size_t k = 0; k < n; ++k) direction_[k] = mu[active[k]];
  const double work = dot(direction_, b), energy = dot(direction_, product_);
  const double share = energy > 0.0 ? std::clamp(work / energy, 0.0, 1.0) : 0.0;
  if (share == 1.0) return;
  for (std::size_t k = 0; k < n; ++k) mu[active[k]] *= static_cast<Real>(share);
}

template <class Real>
std::size_t OneSidedSolver<Real>::bytes() const {
  return 4 * residual_.capacity() * sizeof(Real) + off_.capacity() + search_.bytes();
}

template class OneSidedSolver<float>;
template class OneSidedSolver<double>;

}  // namespace ice_ice_baby
