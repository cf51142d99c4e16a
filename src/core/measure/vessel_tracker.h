// Counts what enters and leaves each vessel and gauge.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "measure/measured_vessels.h"

namespace ice_ice_baby {

/// A particle that comes into the scene inside a vessel enters it, and one that goes leaves it, so
/// that what entered minus what left is always the change of what is inside.
template <class Real>
class VesselTracker {
 public:
  /// Particles since the start.
  struct Totals {
    std::uint64_t entered = 0;
    std::uint64_t left = 0;
  };

  /// Particles per second.
  struct Rates {
    double in_1_s = 0.0;
    double out_1_s = 0.0;
  };

  /// Begins to count. @param solids ids of particles of floating solids, which do not count
  /// @param time_s now
  VesselTracker(const Scene& scene, const Particles<Real>& particles,
                const Colliders<Real>& colliders, const Spawn& solids, double time_s);

  /// Particles were appended; none of them is in a vessel until the next call of observe.
  void add(std::size_t count);
  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  /// Counts who has entered and left since the last call.
  void observe(const Particles<Real>& particles, const Colliders<Real>& colliders);
  /// A frame ended, after `observe`.
  void endFrame(double time_s);

  const Totals& totals(std::size_t vessel) const { return totals_[vessel]; }
  /// Mean over the last kWindow_s, or since the counting began.
  Rates rates(std::size_t vessel) const;

  std::size_t bytes() const;

 private:
  static constexpr double kWindow_s = 0.5;

  struct Moment {
    double time_s;
    std::vector<Totals> totals;
  };

  void compare(std::size_t group, const std::vector<VesselNumber>& now);

  MeasuredVessels vessels_;
  Spawn solids_;
  std::vector<std::vector<VesselNumber>> where_;  ///< for each group, (n) at the last call
  std::vector<std::uint64_t> inside_;             ///< (vessels) particles at the last call
  std::vector<Totals> totals_;                    ///< (vessels)
  std::deque<Moment> moments_;                    ///< ends of the frames in the window
  std::vector<VesselNumber> now_, scratch_;
};

}  // namespace ice_ice_baby
