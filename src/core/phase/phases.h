// What each particle is where particles differ: water, ice or steam, or part of a floating solid,
// and what the solver has to know of it.
#pragma once

#include <cstdint>
#include <vector>

#include "ice_ice_baby/samples.h"
#include "ice_ice_baby/scene.h"
#include "particles/neighbours.h"
#include "phase/enthalpy_curve.h"

namespace ice_ice_baby {

template <class Real>
class Phases {
 public:
  /// All particles are water until the first update.
  Phases(const Scene& scene, std::size_t particles);

  /// Makes particles part of a solid, which they stay.
  /// @param first index of the first of them
  /// @param volumes relative to a particle of water, of one after the other
  void makeSolid(std::size_t first, const std::vector<double>& volumes);

  /// Appends particles of water.
  void add(std::size_t count);

  /// Appends the particles that `enthalpy_j_kg` has beyond those known so far. Until the next
  /// update they are water, of the volume that their enthalpy gives them.
  /// @param enthalpy_j_kg (n)
  void add(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg);

  /// Updates the phases from the enthalpies, with the hysteresis of the scene. Water becomes ice
  /// only once it has expanded to the volume of ice.
  /// @param enthalpy_j_kg (n)
  /// @returns whether any particle changed its phase
  bool update(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg);

  /// Moves the volumes towards those of the latest update. Freezing, thawing and condensing change
  /// the volume over half a second, so that nothing is thrown.
  /// @param dt_s simulated time; infinite: at once
  void swell(double dt_s);

  /// Finds the ice that touches water. Call it when phases or neighbours have changed.
  void findWet(const Neighbours<Real>& neighbours);

  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  Phase of(std::size_t i) const { return phase_[i]; }
  bool solid(std::size_t i) const { return phase_[i] == Phase::kSolid; }
  /// Whether the particle belongs to a rigid body.
  bool rigid(std::size_t i) const { return solid(i) || (ice(i) && !elastic_); }
  bool ice(std::size_t i) const { return phase_[i] == Phase::kIce; }
  bool steam(std::size_t i) const { return steam_[i] != 0; }
  /// Whether the particle became ice in the latest update.
  bool newIce(std::size_t i) const { return new_ice_[i] != 0; }
  /// Collider that the particle froze to, until it melts; kNone if none.
  Index stuckTo(std::size_t i) const { return stuck_to_[i]; }
  void stick(std::size_t i, Index collider) { stuck_to_[i] = collider; }
  std::size_t size() const { return phase_.size(); }
  std::size_t iceCount() const { return ice_count_; }
  std::size_t steamCount() const { return steam_count_; }

  /// (n)
  const std::vector<Phase>& all() const { return phase_; }
  /// (n) volume relative to water at rest: 1 / ice.density_ratio for ice, 0 for steam.
  /// Particles of a solid fill its shape.
  const std::vector<Real>& relativeVolume() const { return relative_volume_; }
  /// (n) ice fraction of particles that still flow; 0 for ice and steam.
  const std::vector<Real>& slush() const { return slush_; }
  /// (n) 1 for steam.
  const std::vector<std::uint8_t>& steamFlags() const { return steam_; }
  /// (n) 1 for particles with a density constraint: water, and elastic ice.
  const std::vector<std::uint8_t>& flows() const { return flows_; }
  /// (n) 1 for particles that feel pressure: those that flow, and ice next to them.
  const std::vector<std::uint8_t>& wet() const { return wet_; }
  /// (n) 1 for wet particles and the ice next to them. Without these the force of dry ice on a wet
  /// particle would have no reaction.
  const std::vector<std::uint8_t>& pressed() const { return pressed_; }

  std::size_t bytes() const;

  /// Flags and counts are recomputed from the phases.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.phase_, self.relative_volume_, self.target_volume_, self.swelling_, self.slush_,
            self.wet_, self.pressed_, self.stuck_to_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles
  /// @param colliders of the scene, to which ice may stick
  void restore(std::size_t particles, std::size_t colliders);

 private:
  void resizeAsWater(std::size_t n);
  Phase next(std::size_t i, const EnthalpyCurve& curve, double enthalpy_j_kg) const;

  double freeze_below_c_;
  double melt_above_c_;
  double expansion_;  ///< relative volume of ice
  bool elastic_;
  std::vector<Phase> phase_;
  std::vector<Real> relative_volume_;
  std::vector<Real> target_volume_;  ///< (n) where the relative volume is going
  bool swelling_ = false;            ///< whether any is not there yet
  std::vector<Real> slush_;
  std::vector<std::uint8_t> steam_;
  std::vector<std::uint8_t> flows_;
  std::vector<std::uint8_t> wet_;
  std::vector<std::uint8_t> pressed_;
  std::vector<std::uint8_t> new_ice_;
  std::vector<Index> stuck_to_;
  std::size_t ice_count_ = 0;
  std::size_t steam_count_ = 0;
  std::vector<Real> scratch_;
  std::vector<Phase> phase_scratch_;
  std::vector<std::uint8_t> flag_scratch_;
  std::vector<Index> index_scratch_;
};

}  // namespace ice_ice_baby
