// Simulator: particles and colliders.
#include "base/parallel.h"
#include "colliders/clearance.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

/// Calls answer(i) for every particle whose path to x*, or to x* + `by`, may touch a collider.
/// @param answer moves the particle out of them; returns by how much, m
template <class Real>
template <class Answer>
void Simulator<Real>::respond(const VectorField<Real>* by, const Answer& answer) {
  const IceBodies<Real>* bodies = this->bodies();
  const Paths<Real> paths{particles_.position, particles_.predicted, by};
  VectorField<Real>* pushes = wrench_meter_ ? &wrench_meter_->pushes(particles_.size()) : nullptr;
  parallelForRanges(particles_.size(), [&](std::size_t first, std::size_t last) {
    forEachNear(colliders_, paths, Real(0), first, last, [&](std::size_t i) {
      if (bodies && bodies->memberAt(Index(i)) != kNone) return;
      const Vec3<Real> push = answer(i);
      if (pushes) pushes->set(i, push);
    });
  });
  if (wrench_meter_) wrench_meter_->addPushes(particles_.predicted);
}

/// Changes delta p so that x* + delta p lies outside every collider.
template <class Real>
void Simulator<Real>::respondToCollisions() {
  VectorField<Real>& delta_p = fluid_->deltaP();
  if (wrench_meter_) wrench_meter_->addWalls(*fluid_, particles_.predicted);
  respond(&delta_p, [&](std::size_t i) {
    const Vec3<Real> predicted = particles_.predicted.at(i);
    const Vec3<Real> wanted = predicted + delta_p.at(i);
    const Vec3<Real> end = colliders_.respond(particles_.position.at(i), wanted, sticks());
    delta_p.set(i, end - predicted);
    return Vec3<Real>(end - wanted);
  });
}

/// Moves particles out of colliders that springs or free flight moved into them.
template <class Real>
void Simulator<Real>::finishCollisions() {
  respond(nullptr, [&](std::size_t i) {
    const Vec3<Real> wanted = particles_.predicted.at(i);
    const Vec3<Real> end = colliders_.respond(particles_.position.at(i), wanted, sticks());
    particles_.predicted.set(i, end);
    return Vec3<Real>(end - wanted);
  });
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
