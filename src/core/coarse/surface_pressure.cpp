// The pressure of the coarse level at the surface of the water.
#include <algorithm>

#include "base/parallel.h"
#include "coarse/displacement_projection.h"

namespace ice_ice_baby {

namespace {

/// A particle is at the surface if less than this share of its surroundings is filled, and if its
/// pressure is that of fewer layers.
constexpr double kAtSurface = 0.65, kSurfaceLayers = 5.0;

}  // namespace

/// The splines of a grid end somewhere in its cells and not at the surface of the water, where the
/// pressure is that of half a layer. What is left there in the mean is taken off all the water of
/// the grid, if it is slow; forces do not change.
template <class Real>
void DisplacementProjection<Real>::levelPressure(const Vec3<Real>& gravity, Real dt) {
  if (active_.empty()) return;
  findShares();
  const std::vector<Index>& order = grids_.order();
  const CoarseGrid<Real>* first = grids_.grids().data();
  const Real layer = spacing_ * gravity.norm() * dt * dt;
  const Real fast = static_cast<Real>(2 * kFast_falls) * layer / (spacing_ * grids_.cell_m());
  const Real fast2 = fast * fast;
  surface_.assign(grids_.grids().size(), {0.0, 0.0});
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Real value = multiplier_[order[k]];
    const bool candidate = value != 0 && -value <= static_cast<Real>(kSurfaceLayers) * layer &&
                           sorted_.drift2[k] <= fast2;
    if (!candidate || !atSurface(k)) continue;
    auto& [sum, count] = surface_[std::size_t(&grids_.gridOf(order[k]) - first)];
    sum += double(value);
    count += 1.0;
  }
  left_.clear();
  for (const auto& [sum, count] : surface_) {
    left_.push_back(count > 0 ? std::min(Real(0), static_cast<Real>(sum / count) + layer / 2) : 0);
  }
  parallelFor(order.size(), [&](std::size_t k) {
    const Index i = order[k];
    if (multiplier_[i] == 0) return;
    multiplier_[i] = std::min(Real(0), multiplier_[i] - excessAt(i));
  });
}

template <class Real>
Real DisplacementProjection<Real>::excessAt(Index i) const {
  return left_[std::size_t(&grids_.gridOf(i) - grids_.grids().data())];
}

/// Takes the same off the pressure that pushes bodies: where it is no more than what is left at the
/// surface, there is no pressure. Without it a floating body is lifted by what is left, which fades
/// within the part of the body that lies above the water.
template <class Real>
void DisplacementProjection<Real>::levelBodies(Particles<Real>& particles,
                                               const IceBodies<Real>& bodies) const {
  const std::vector<Index>& order = grids_.order();
  parallelFor(order.size(), [&](std::size_t k) {
    const Index i = order[k];
    const bool pushed = value_[k] != 0;
    if (!pushed || multiplier_[i] < 0 || bodies.memberAt(i) == kNone) return;
    particles.predicted.add(i, -pushOn(k));
  });
}

/// Displacement of particle k of the order by the pressure at its nodes, whatever holds it.
template <class Real>
Vec3<Real> DisplacementProjection<Real>::pushOn(std::size_t k) const {
  const Index i = grids_.order()[k];
  const CoarseGrid<Real>& grid = grids_.gridOf(i);
  const std::size_t lowest = grids_.lowestNodeOf(i);
  const SplineAt<Real> spline(sorted_, k);
  Vec3<Real> slope = Vec3<Real>::Zero();
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    slope += mu_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))] * spline.slope(a);
  }
  const Real cell2 = grids_.cell_m() * grids_.cell_m();
  const Vec3<Real> push = sorted_.volume[k] * cell2 * slope.cwiseQuotient(grid.region.cell_m);
  return grid.region.frame.rotation * push;
}

/// Share of the room around each node that is filled.
template <class Real>
void DisplacementProjection<Real>::findShares() {
  const std::vector<Real>& rest = free_volume_.atNodes();
  share_.reserve(rest.capacity());
  share_.resize(rest.size());
  parallelFor(rest.size(), [&](std::size_t node) {
    const Real fill = deposits_[node * kDeposits + 1];
    share_[node] = rest[node] > 0 ? std::min(Real(1), fill / rest[node]) : Real(1);
  });
}

/// Whether a third of the surroundings of particle k of the order, as its nodes see them, is empty.
template <class Real>
bool DisplacementProjection<Real>::atSurface(std::size_t k) const {
  const Index i = grids_.order()[k];
  const CoarseGrid<Real>& grid = grids_.gridOf(i);
  const std::size_t lowest = grids_.lowestNodeOf(i);
  const SplineAt<Real> spline(sorted_, k);
  Real filled = 0;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    filled += share_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))] * spline.value(a);
  }
  return filled < static_cast<Real>(kAtSurface);
}

template class DisplacementProjection<float>;
template class DisplacementProjection<double>;

}  // namespace ice_ice_baby
