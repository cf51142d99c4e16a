// What each particle is where heat lets particles differ: water, ice or steam, and what the solver
// has to know of it.
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

  /// Appends the particles that `enthalpy_j_kg` has beyond those known so far. Until the next
  /// update they are water, of the volume that their enthalpy gives them.
  /// @param enthalpy_j_kg (n)
  void add(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg);

  /// Follows the enthalpies, with the hysteresis of the scene. Water turns to ice only once it has
  /// the volume of ice.
  /// @param enthalpy_j_kg (n)
  /// @returns whether any particle changed its phase
  bool update(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg);

  /// Lets volumes follow the enthalpies of the latest update: what freezing swells or thawing
  /// shrinks takes half a second, as does what condenses, so that nothing is thrown.
  /// @param dt_s simulated time; infinite: at once
  void swell(double dt_s);

  /// Finds out which ice touches water; to be called when phases or neighbours have changed.
  void findWet(const Neighbours<Real>& neighbours);

  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  Phase of(std::size_t i) const { return phase_[i]; }
  bool ice(std::size_t i) const { return phase_[i] == Phase::kIce; }
  bool steam(std::size_t i) const { return steam_[i] != 0; }
  /// Whether the particle became ice in the latest update.
  bool newIce(std::size_t i) const { return new_ice_[i] != 0; }
  /// Ice that froze to a collider stays there until it melts: number of it, or kNone.
  Index stuckTo(std::size_t i) const { return stuck_to_[i]; }
  void stick(std::size_t i, Index collider) { stuck_to_[i] = collider; }
  std::size_t size() const { return phase_.size(); }
  std::size_t iceCount() const { return ice_count_; }
  std::size_t steamCount() const { return steam_count_; }

  /// (n) volume over that of water at rest: 1 / ice.density_ratio for ice, 0 for steam.
  const std::vector<Real>& relativeVolume() const { return relative_volume_; }
  /// (n) ice fraction of what still flows, 0 for ice and steam.
  const std::vector<Real>& slush() const { return slush_; }
  /// (n) 1 for steam.
  const std::vector<std::uint8_t>& steamFlags() const { return steam_; }
  /// (n) 1 where a density constraint holds: water, and ice that is elastic.
  const std::vector<std::uint8_t>& flows() const { return flows_; }
  /// (n) 1 where water presses: what flows, and the ice beside it.
  const std::vector<std::uint8_t>& wet() const { return wet_; }
  /// (n) 1 for those and the ice beside them, on which they press in turn: without it what a wet
  /// particle takes from dry ice has no reaction.
  const std::vector<std::uint8_t>& pressed() const { return pressed_; }

  std::size_t bytes() const;

  /// Flags and counts follow from the phases; those of the latest update are for that alone.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.phase_, self.relative_volume_, self.target_volume_, self.swelling_, self.slush_,
            self.wet_, self.pressed_, self.stuck_to_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles
  /// @param colliders of the scene, to which ice may stick
  void restore(std::size_t particles, std::size_t colliders);

 private:
  Phase next(std::size_t i, const EnthalpyCurve& curve, double enthalpy_j_kg) const;

  double freeze_below_c_;
  double melt_above_c_;
  double expansion_;  ///< of freezing, by volume
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
