// Steam: boiled water that no density constraint holds. It rises with drag, and heat condenses it.
#pragma once

#include "particles/particles.h"
#include "phase/phases.h"

namespace ice_ice_baby {

/// Density at 100 degrees C and 1 bar over that of water, 0.6 kg/m^3. Reported, but nothing in the
/// simulation follows from it.
constexpr float kSteamDensity = 6e-4f;

template <class Real>
class Steam {
 public:
  explicit Steam(const SteamParams& params) : params_(params) {}

  /// Replaces free fall: v goes to steam.rise_speed_m_s, by up to half more or less for each
  /// puff, against gravity at the rate steam.drag_1_s, and x* = x + dt v. Without gravity it comes
  /// to a stop.
  /// @param particles just predicted in free fall
  void predict(Particles<Real>& particles, const Phases<Real>& phases, const Vec3d& gravity_m_s2,
               double dt_s) const;

 private:
  SteamParams params_;
};

}  // namespace ice_ice_baby
