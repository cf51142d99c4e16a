// Water that sources add in every substep and drains remove in every frame.
#include <algorithm>

#include "flow/free_places.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

/// Number of particles that can still be added.
template <class Real>
double Simulator<Real>::room() const {
  const double ids = double(kNone) - double(particles_.next_id);
  return std::min(scene_.limits.max_particles - double(particles_.owned()), ids);
}

/// Adds what the sources emitted in a substep that ends now. Only a substep is short enough: fast
/// water between two frames would appear far from the outlet, behind walls and in other water.
template <class Real>
void Simulator<Real>::pour(int substep, int substeps) {
  if (!anyOpen(scene_.sources)) return;
  if (substep == 0) sources_->beginFrame(scene_, farthest_m());
  sources_->setSubstep(double(substep) / substeps, double(substep + 1) / substeps);
  const double dt_s = 1.0 / (scene_.solver.frame_rate_hz * substeps);
  const std::uint32_t first_id = particles_.next_id;
  for (std::size_t k = 0; k < sources_->count(); ++k) {
    const std::vector<Drop>& drops = sources_->advance(scene_, k, dt_s, room());
    if (!drops.empty()) pourFrom(k, drops);
  }
  report_.sources_stopped = sources_->stopped(scene_, room());
  if (particles_.next_id != first_id) settleNew(first_id);
}

/// Adds the drops of source k for which there is a place. Water in the way of the others is pushed
/// away from the disc, as by the water behind it: an outlet below the surface could not start
/// otherwise.
template <class Real>
void Simulator<Real>::pourFrom(std::size_t k, const std::vector<Drop>& drops) {
  FreePlaces<Real> places(colliders_, particles_, scene_.fluid.spacing_m, drops);
  std::vector<Vec3d> position_m, velocity_m_s;
  std::vector<Index> in_the_way;
  for (Drop drop : drops) {
    if (places.take(drop, in_the_way)) {
      position_m.push_back(drop.position_m);
      velocity_m_s.push_back(drop.velocity_m_s);
      continue;
    }
    report_.blocked += sources_->keep(k, drop);
    for (const Index i : in_the_way) pushAlong(i, drop.velocity_m_s);
  }
  report_.poured += position_m.size();
  particles_.add(position_m, velocity_m_s);
  if (vessel_tracker_) vessel_tracker_->add(position_m.size());
  if (phase_change_) phase_change_->add(position_m.size(), scene_.sources[k].temperature_c);
}

/// Gives water at least the speed of a flow, along it.
template <class Real>
void Simulator<Real>::pushAlong(Index i, const Vec3d& velocity_m_s) {
  if (!fluidAt(i)) return;
  const Vec3d along = velocity_m_s.normalized();
  const Vec3d now_m_s = particles_.velocity.at(i).template cast<double>();
  const double missing_m_s = velocity_m_s.norm() - now_m_s.dot(along);
  if (missing_m_s <= 0.0) return;
  const Vec3d pushed_m_s = now_m_s + missing_m_s * along;
  particles_.velocity.set(i, pushed_m_s.template cast<Real>());
}

/// Whether a particle is no part of anything solid: of ice, of frozen water, of a sheet or of a
/// floating solid.
template <class Real>
bool Simulator<Real>::fluidAt(Index i) const {
  if (solidAt(i)) return false;
  if (scene_.thermal.enabled) return !phases()->ice(i);
  for (std::size_t k = 0; k < scene_.blocks.size(); ++k) {
    if (scene_.blocks[k].sheet && particles_.id[i] - spawns_[k].first_id < spawns_[k].count) {
      return false;
    }
  }
  return !frozen();
}

/// Removes what the drains take in a frame.
template <class Real>
void Simulator<Real>::drain() {
  std::vector<char> gone(particles_.size(), false), stays(particles_.size());
  for (Index i = 0; i < particles_.size(); ++i) stays[i] = !fluidAt(i);
  if (drains_->choose(scene_, particles_, gone, stays) == 0) return;
  report_.drained += remove(gone);
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
