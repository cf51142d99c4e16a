// Checks state read from a checkpoint, and computes what is not stored. The bytes are untrusted, so
// every index is checked against its range here before it is used.
#include "checkpoint/restored_state.h"

#include <algorithm>

#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Largest density, and largest multiplier, m^2.
constexpr double kMax = 1e30;

/// Longest delay of thermal passes and updates of phases, s.
constexpr double kLongestWait_s = 1.0;

constexpr double kLongestRamp_s = 1e6;

/// Volume of a particle of a solid relative to one of water, at most.
constexpr double kLargestPart = 8.0;

bool isTemperature(double celsius) {
  return within(celsius, kTemperatureRange_c.min, kTemperatureRange_c.max);
}

template <class Real>
bool isPose(const Pose<Real>& pose) {
  return pose.position.cwiseAbs().maxCoeff() <= kMaxCoordinate_m && isRotation(pose.rotation);
}

template <class Real>
bool holds(const VectorField<Real>& field, std::size_t count) {
  return field.x.size() == count && field.y.size() == count && field.z.size() == count;
}

template <class Real>
bool allCoordinatesWithin(const VectorField<Real>& field, double max) {
  return allWithin(field.x, -max, max) && allWithin(field.y, -max, max) &&
         allWithin(field.z, -max, max);
}

}  // namespace

template <class Real>
void Particles<Real>::restore(std::size_t count) {
  std::vector<std::uint32_t> sorted = id;
  std::sort(sorted.begin(), sorted.end());
  const bool once = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  requireValid(id.size() == count && once && (count == 0 || sorted.back() < next_id),
               "particle ids not unique");
  requireValid(holds(position, count) && holds(velocity, count),
               "particle arrays of different lengths");
  requireValid(allCoordinatesWithin(position, kMaxStoredCoordinate_m),
               "particle position out of range");
  requireValid(allCoordinatesWithin(velocity, kFastest_m_s), "particle speed out of range");
  predicted = position;
}

template <class Real>
void DensityConstraint<Real>::restore(std::size_t particles) {
  const std::size_t started = warmStarts() ? particles : 0;
  requireValid(density_.size() == particles && multiplier_.size() == particles &&
                   holds(correction_, started),
               "densities of a different number of particles");
  requireValid(allWithin(density_, -kMax, kMax) && allWithin(multiplier_, -kMax, kMax) &&
                   allCoordinatesWithin(correction_, kMaxStoredCoordinate_m),
               "density out of range");
  resize(particles);
}

template <class Real>
void DisplacementProjection<Real>::restore(std::size_t particles) const {
  requireValid(multiplier_.size() == particles && allWithin(multiplier_, -kMax, kMax),
               "pressure of the coarse level out of range");
  for (const Guess& guess : guess_) {
    requireValid(within(double(guess.mu), -kMax, 0.0), "pressure of the coarse level out of range");
  }
}

template <class Real>
void Fluid<Real>::restore(std::size_t particles) {
  constraint_.restore(particles);
  if (coarse_) coarse_->restore(particles);
}

template <class Real>
void Neighbours<Real>::restore(std::size_t particles) {
  if (particles == 0) {
    count_.clear();
    return;
  }
  requireValid(holds(built_at_, particles + kPadding) && builds_ > 0,
               "neighbour lists of other particles");
  VectorField<Real> where = built_at_;
  where.resize(particles);
  const std::size_t builds = builds_;
  const std::vector<Index>& order = sortOrder(where);
  requireValid(std::is_sorted(order.begin(), order.end()), "particles not sorted by cell");
  build(where);
  builds_ = builds;
}

template <class Real>
void Colliders<Real>::restore() const {
  const bool motions = std::all_of(begin(), end(), [&](const MovingShape<Real>& collider) {
    return isPose(collider.motion.from) && isPose(collider.motion.to);
  });
  const bool travels = std::all_of(travels_.begin(), travels_.end(), [&](const Travel& travel) {
    return isPose(travel.start) && isPose(travel.target);
  });
  requireValid(travels && motions, "collider pose out of range");
}

template <class Real>
void Springs<Real>::restore(std::size_t particles) const {
  requireValid(sheet_count_ <= springs_.size(), "more sheet springs than springs");
  for (const Spring<Real>& spring : springs_) {
    requireValid(spring.a < particles && spring.b < particles, "spring between unknown particles");
    requireValid(within(double(spring.rest_m), 0.0, kMaxCoordinate_m),
                 "spring length out of range");
  }
}

void Temperature::restore() const {
  const auto possible = [](const TemperatureEvent& event) {
    return isTemperature(event.celsius) && within(event.ramp_s, 0.0, kLongestRamp_s);
  };
  requireValid(isTemperature(celsius_) && isTemperature(from_c_) && isTemperature(target_c_) &&
                   within(ramp_s_, 0.0, kLongestRamp_s) &&
                   std::all_of(schedule_.begin(), schedule_.end(), possible),
               "temperature out of range");
}

template <class Real>
void ThermalBoundaries<Real>::restore() const {
  for (const Surface& one : surfaces_) {
    requireValid(isTemperature(one.celsius) && isTemperature(one.target_c) &&
                     within(one.ramp_left_s, 0.0, kLongestRamp_s),
                 "surface temperature out of range");
  }
}

void HeatedRegions::restore(const Scene& scene) const {
  requireValid(active_.size() <= kMaxHeatedRegions, "too many heated regions");
  for (const HeatedRegion& region : active_) requireHeatedRegion(scene, region);
}

void SceneRegions::restore() const {
  for (const Region& one : all_) {
    requireValid(isPose(one.pose) && within(one.owed_j, -kMax, kMax), "heat region out of range");
  }
}

template <class Real>
void ThermalSolver<Real>::restore(std::size_t particles, const Scene& scene) const {
  requireValid(enthalpy_.size() == particles && received_.size() == particles,
               "temperatures of a different number of particles");
  const bool possible = std::all_of(enthalpy_.begin(), enthalpy_.end(), [&](double enthalpy_j_kg) {
    return curve_.clampToRange(enthalpy_j_kg) == enthalpy_j_kg;
  });
  requireValid(possible && allWithin(received_, -kMax, kMax), "enthalpy out of range");
  requireValid(within(passes_, 0, kMaxPasses) && longest_pass_s_ >= 0.0 && reached_speedup_ >= 0.0,
               "thermal pass out of range");
  walls_.restore();
  regions_.restore(scene);
  if (scene_regions_) scene_regions_->restore();
}

template <class Real>
void Phases<Real>::restore(std::size_t particles, std::size_t colliders) {
  for (const std::size_t size : {phase_.size(), relative_volume_.size(), target_volume_.size(),
                                 slush_.size(), wet_.size(), pressed_.size(), stuck_to_.size()}) {
    requireValid(size == particles, "phases of a different number of particles");
  }
  ice_count_ = steam_count_ = 0;
  for (auto* flags : {&steam_, &flows_, &new_ice_}) flags->assign(particles, 0);
  for (std::size_t i = 0; i < particles; ++i) {
    requireValid(phase_[i] <= Phase::kSolid, "unknown phase");
    requireValid(belowOrNone(stuck_to_[i], colliders), "ice frozen to an unknown collider");
    // Except for steam, densities differ from that of water by a factor of two at most.
    const double largest = solid(i) ? kLargestPart : 2.0;
    requireValid(within(double(relative_volume_[i]), 0.0, largest) &&
                     within(double(target_volume_[i]), 0.0, largest) &&
                     within(double(slush_[i]), 0.0, 1.0),
                 "relative volume out of range");
    ice_count_ += phase_[i] == Phase::kIce;
    steam_count_ += phase_[i] == Phase::kSteam;
    steam_[i] = phase_[i] == Phase::kSteam;
    flows_[i] = phase_[i] == Phase::kWater || (elastic_ && phase_[i] == Phase::kIce);
  }
}

template <class Real>
void PhaseChange<Real>::restore(const Particles<Real>& particles) {
  if (heat_) heat_->restore(particles.size(), scene_);
  phases_.restore(particles.size(), colliders_.count());
  updateSteam();
  const bool any = rigid() || !scene_.solids.empty();
  requireValid(bodies_.has_value() == contacts_.has_value() && (any || !bodies_),
               "ice bodies in a scene without rigid ice");
  requireValid(
      within(heat_due_s_, 0.0, kLongestWait_s) && within(phases_due_s_, 0.0, kLongestWait_s),
      "delay of thermal passes out of range");
  if (!bodies_) return;
  bodies_->restore(particles, colliders_);
  contacts_->restore(*bodies_);
}

void SubstepControl::restore() const {
  requireValid(within(substeps_, 1, 1000) && within(fewest_, 1, 1000),
               "number of substeps out of range");
}

void OutletMotion::restore() const {
  requireValid(isPose(start_) && isPose(target_), "pose of a source out of range");
}

void Sources::restore() const {
  for (const Outflow& one : outflows_) {
    requireValid(within(one.progress, 0.0, 1.0) && allWithin(one.waiting, 0.0, 1.0) &&
                     one.waiting.size() == one.outlet.sites.size(),
                 "source out of range");
    one.motion.restore();
  }
}

void Drains::restore(const Scene& scene) const {
  requireValid(allowance_.size() == scene.drains.size() && allWithin(allowance_, 0.0, 1.0),
               "drain out of range");
}

template <class Real>
void Simulator<Real>::restore(std::size_t n) {
  particles_.restore(n);
  fluid_->restore(n);
  colliders_.restore();
  substep_control_.restore();
  requireValid(within(strictness_, 0.0, 1.0), "strictness out of range");
  requireValid(still_s_ >= 0.0 && report_.time_s >= 0.0 && within(report_.substeps, 0, 1000),
               "time out of range");
  const std::uint64_t gone = particles_.next_id - n;
  requireValid(report_.spilled <= gone && report_.drained <= gone - report_.spilled,
               "more particles left than there were");
  requireValid(report_.poured <= particles_.next_id - spawned(),
               "more particles came out of sources than there were");
  if (sources_) sources_->restore();
  if (drains_) drains_->restore(scene_);
  temperature_.restore();
  report_.particles = n;
  report_.springs = springs_ ? springs_->size() : 0;
  if (springs_) springs_->restore(n);
  if (phase_change_) phase_change_->restore(particles_);
  temperature_.advanceTo(report_.time_s);
  arena_.execute([&] { neighbours_.restore(n); });
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
