// Colliders that are somewhere else at once: what they hold comes along, what they land on makes
// room, and nothing of it counts as speed.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "colliders/clearance.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Water that was pressed together parts in so many corrections at most, or until the densest
/// particle is within this share of rest.
constexpr int kMostCorrections = 100;
constexpr double kDense = 0.05;

/// What was put aside by less than this, in spacings, presses on nothing.
constexpr double kPressed_d = 0.01;

}  // namespace

/// Faster than the speed limit nothing could follow a collider or get out of its way.
template <class Real>
void Simulator<Real>::jumpColliders() {
  double far2 = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    far2 = std::max(far2, double(particles_.position.at(i).squaredNorm()));
  }
  const double most_m = scene_.solver.max_speed_m_s / scene_.solver.frame_rate_hz;
  const std::vector<Jump<Real>> jumps = colliders_.jump(most_m, std::sqrt(far2));
  if (jumps.empty()) return;
  carry(jumps);
  if (bodies_) {
    bodies_->carry(jumps, colliders_);
    contacts_->expel(*bodies_, colliders_);
    bodies_->finish(particles_);
  }
  fluid_->forget();
  expel();
}

/// Takes along what lies in containers that jump, its velocity turned with them.
template <class Real>
void Simulator<Real>::carry(const std::vector<Jump<Real>>& jumps) {
  std::size_t carried = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    if (inBody(i)) continue;
    for (const Jump<Real>& jump : jumps) {
      if (jump.number >= colliders_.containers.size()) break;
      const Vec3<Real> local = jump.motion.from.toLocal(particles_.position.at(i));
      if (!colliders_.containers[jump.number].shape.inside(local)) continue;
      const Mat3<Real> turn = jump.motion.to.rotation * jump.motion.from.rotation.transpose();
      particles_.position.set(i, jump.motion.to.toWorld(local));
      particles_.velocity.set(i, turn * particles_.velocity.at(i));
      ++carried;
      break;
    }
  }
  particles_.predicted = particles_.position;
  report_.speed_limited += carried;
}

/// Puts water that lies in a collider beside it.
template <class Real>
void Simulator<Real>::expel() {
  double furthest = 0.0;
  const Paths<Real> paths{particles_.position, particles_.position};
  forEachNear(colliders_, paths, Real(0), 0, particles_.size(), [&](std::size_t i) {
    if (inBody(i)) return;
    const Vec3<Real> from = particles_.position.at(i);
    const Vec3<Real> end = colliders_.respond(from, from, false);
    furthest = std::max(furthest, double((end - from).norm()));
    particles_.position.set(i, end);
    particles_.predicted.set(i, end);
  });
  if (furthest > kPressed_d * scene_.fluid.spacing_m) makeRoom();
}

/// Corrects density as the iterations of a substep do, but in no time, so that it is not velocity.
template <class Real>
void Simulator<Real>::makeRoom() {
  for (int k = 0; k < kMostCorrections; ++k) {
    findNeighbours();
    fluid_->updateDensity(particles_, neighbours_);
    if (static_cast<Real>(fluid_->maxDensity()) < Real(1 + kDense)) break;
    fluid_->updateCorrections(particles_, neighbours_);
    respondToCollisions();
    updatePredicted();
    if (bodies_) bodies_->writePredicted(particles_.predicted);
    particles_.position = particles_.predicted;
  }
  fluid_->forget();
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
