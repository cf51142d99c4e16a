// Adds and removes particles between two frames.
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "ice_ice_baby/errors.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

void requireVelocity(const Vec3d& velocity_m_s, double max_speed_m_s) {
  const double speed_m_s = velocity_m_s.norm();
  requireInRange("speed of a new particle in m/s", speed_m_s, 0.0, max_speed_m_s);
}

void requirePosition(const Vec3d& position_m, const BoundsParams& bounds) {
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange(std::string(1, "xyz"[axis]) + " of a new particle in m", position_m[axis],
                   bounds.min_m[axis], bounds.max_m[axis]);
  }
}

/// The bounds of a scene in the precision of its particles.
template <class Real>
class Bounds {
 public:
  explicit Bounds(const BoundsParams& params)
      : low_(params.min_m.cast<Real>()), high_(params.max_m.cast<Real>()) {}

  bool excludes(const Vec3<Real>& x) const {
    return (x.array() < low_.array()).any() || (x.array() > high_.array()).any();
  }

  bool excludesAny(const VectorField<Real>& x) const {
    std::atomic<bool> excluded{false};
    parallelForRanges(x.size(), [&](std::size_t first, std::size_t last) {
      unsigned outside = 0;
      for (std::size_t i = first; i != last; ++i) {
        outside |= unsigned(x.x[i] < low_.x()) | unsigned(x.x[i] > high_.x()) |
                   unsigned(x.y[i] < low_.y()) | unsigned(x.y[i] > high_.y()) |
                   unsigned(x.z[i] < low_.z()) | unsigned(x.z[i] > high_.z());
      }
      if (outside != 0) excluded.store(true, std::memory_order_relaxed);
    });
    return excluded;
  }

 private:
  Vec3<Real> low_, high_;
};

}  // namespace

template <class Real>
std::uint32_t Simulator<Real>::addParticles(const std::vector<Vec3d>& position_m,
                                            const std::vector<Vec3d>& velocity_m_s,
                                            double celsius) {
  const std::size_t count = position_m.size();
  if (velocity_m_s.size() != count) {
    throw InvalidInput(std::to_string(count) + " positions of new particles and " +
                       std::to_string(velocity_m_s.size()) + " velocities; give one for each");
  }
  for (const Vec3d& x : position_m) requirePosition(x, scene_.bounds);
  for (const Vec3d& v : velocity_m_s) requireVelocity(v, scene_.solver.max_speed_m_s);
  requireTemperature(celsius, 0.0);
  requireInRange("particles with the new ones", double(particles_.owned() + count), 0.0,
                 scene_.limits.max_particles);
  const std::uint32_t first_id = particles_.next_id;
  requireInRange("ids in use with the new ones", double(first_id) + double(count), 0.0,
                 double(kNone));
  if (count == 0) return first_id;
  particles_.add(position_m, velocity_m_s);
  if (phase_change_) phase_change_->add(count, celsius);
  if (vessel_tracker_) vessel_tracker_->add(count);
  arena_.execute([&] { settleNew(first_id); });
  return first_id;
}

/// Makes the particles from `first_id` on, which were appended, part of everything else.
template <class Real>
void Simulator<Real>::settleNew(std::uint32_t first_id) {
  renewNeighbours();
  if (springs_ && springs_->kept()) {
    const double reach_m = scene_.springs.reach_h * scene_.supportRadius_m();
    springs_->joinNew(particles_, neighbours_, phases(), static_cast<Real>(reach_m), first_id);
  }
  followParticles();
}

template <class Real>
std::size_t Simulator<Real>::removeParticles(
    const std::function<bool(std::uint32_t id, const Vec3d& position_m)>& goes) {
  std::vector<char> gone(particles_.size(), false);
  for (Index i = 0; i < particles_.size(); ++i) {
    gone[i] = goes(particles_.id[i], particles_.position.at(i).template cast<double>());
  }
  return remove(gone);
}

/// @param gone (n) whether a particle is to be removed; of a solid that counts only if all are
/// @return number of particles removed
template <class Real>
std::size_t Simulator<Real>::remove(std::vector<char> gone) {
  if (phase_change_) phase_change_->keepWhole(gone);
  std::vector<Index> stay;
  for (Index i = 0; i < particles_.size(); ++i) {
    if (!gone[i]) stay.push_back(i);
  }
  const std::size_t went = gone.size() - stay.size();
  if (went == 0) return 0;
  arena_.execute([&] {
    if (springs_) springs_->removeOf(gone);
    if (phase_change_) phase_change_->release(gone, particles_, neighbours_);
    reorder(stay);
    renewNeighbours();
    followParticles();
  });
  return went;
}

/// Removes the particles that ended the frame outside the bounds of the scene.
template <class Real>
void Simulator<Real>::removeSpilled() {
  const Bounds<Real> bounds(scene_.bounds);
  if (!bounds.excludesAny(particles_.position)) return;
  report_.spilled += removeParticles([&](std::uint32_t, const Vec3d& position_m) {
    return bounds.excludes(position_m.cast<Real>());
  });
}

/// Updates everything that depends on the set of particles. Moves none, except new particles that
/// coincide with another.
template <class Real>
void Simulator<Real>::followParticles() {
  if (neighbours_.coincident()) particles_.position = particles_.predicted;
  if (phase_change_) phase_change_->followParticles(particles_, neighbours_);
  fluid_->updateDensity(particles_, neighbours_);
  observeVessels();
  report_.particles = particles_.owned();
  report_.springs = springs_ ? springs_->size() : 0;
  report_.asleep = false;
  still_s_ = 0.0;
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
