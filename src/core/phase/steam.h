// Steam: boiled water without a density constraint. It rises with drag and condenses when cooled.
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

  /// Replaces free fall: v approaches steam.rise_speed_m_s against gravity at the rate
  /// steam.drag_1_s, and x* = x + dt v. The speed varies by up to half between particles. Without
  /// gravity steam comes to rest.
  /// @param particles after predicting free fall
  void predict(Particles<Real>& particles, const Phases<Real>& phases, const Vec3d& gravity_m_s2,
               double dt_s) const;

 private:
  SteamParams params_;
};

}  // namespace ice_ice_baby
