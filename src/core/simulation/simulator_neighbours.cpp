// Neighbour lists and the order of particles that comes with them.
#include <cmath>

#include "base/parallel.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Unit vector that depends on the id alone, evenly distributed on the sphere (golden angle
/// spiral).
template <class Real>
Vec3<Real> directionOf(std::uint32_t id) {
  const double z = 1.0 - 2.0 * ((id * 2654435761u >> 8) + 0.5) / (1 << 24);
  const double angle = 2.399963229728653 * id;
  const double radius = std::sqrt(1.0 - z * z);
  return Vec3d(radius * std::cos(angle), radius * std::sin(angle), z).template cast<Real>();
}

}  // namespace

template <class Real>
void Simulator<Real>::findNeighbours() {
  if (neighbours_.stale(particles_.predicted)) renewNeighbours();
}

template <class Real>
void Simulator<Real>::renewNeighbours() {
  reorder(neighbours_.sortOrder(particles_.predicted));
  neighbours_.build(particles_.predicted);
  if (phase_change_) phase_change_->followNeighbours(neighbours_);
  if (neighbours_.coincident()) separateCoincident();
}

/// Moves particle order[k] to place k, with all of its state.
template <class Real>
void Simulator<Real>::reorder(const std::vector<Index>& order) {
  particles_.reorder(order);
  fluid_->reorder(order);
  if (springs_) springs_->renumber(order);
  if (phase_change_) phase_change_->reorder(order);
  if (vessel_tracker_) vessel_tracker_->reorder(order);
}

/// Coincident particles have no direction in which to separate, so all but the first are displaced
/// by a hundredth of a spacing, each in its own direction.
template <class Real>
void Simulator<Real>::separateCoincident() {
  const VectorField<Real>& x = particles_.predicted;
  displaced_.assign(particles_.size(), false);
  parallelFor(particles_.size(), [&](std::size_t i) {
    for (const Index j : neighbours_.of(i)) {
      if (x.x[j] != x.x[i] || x.at(j) != x.at(i)) continue;
      if (particles_.id[j] < particles_.id[i]) displaced_[i] = true;
    }
  });
  const Real distance = static_cast<Real>(0.01 * scene_.fluid.spacing_m);
  for (Index i = 0; i < particles_.size(); ++i) {
    if (displaced_[i]) particles_.predicted.add(i, distance * directionOf<Real>(particles_.id[i]));
  }
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
