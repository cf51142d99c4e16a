// Active heat sources and sinks: torches and freezing sprays.
#pragma once

#include <vector>

#include "ice_ice_baby/simulation.h"
#include "particles/particles.h"
#include "thermal/conductances.h"

namespace ice_ice_baby {

/// A box, or the ellipsoid that fits into it.
struct HeatedSpace {
  BlockShape shape;  ///< kBox or kSphere
  Vec3d size_m;      ///< of the box
  Posed pose;        ///< of its centre

  bool holds(const Vec3d& point) const;
};

/// Adds `watts` to `power_w`, spread evenly over the particles in the space that are not of solids;
/// nothing without any.
/// @param power_w (n) W
template <class Real>
void spreadPower(const HeatedSpace& space, double watts, const VectorField<Real>& x,
                 const ThermalStep<Real>& step, std::vector<Real>& power_w);

class HeatedRegions {
 public:
  void add(const HeatedRegion& region) { active_.push_back(region); }

  /// Adds the mean power that each particle receives over the next `step.dt_s` of simulated time to
  /// `power_w`, and removes regions that have ended. A region without particles heats nothing.
  /// @param power_w (n) W
  template <class Real>
  void advance(const VectorField<Real>& x, const ThermalStep<Real>& step,
               std::vector<Real>& power_w);

  std::size_t size() const { return active_.size(); }
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.active_);
  }
  /// @throws InvalidInput when what was read could not have been asked for
  void restore(const Scene& scene) const;

  std::size_t bytes() const { return active_.capacity() * sizeof(HeatedRegion); }

 private:
  std::vector<HeatedRegion> active_;  ///< duration_s: the remaining time
};

}  // namespace ice_ice_baby
