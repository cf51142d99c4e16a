#include "ice_ice_baby/phases.h"

#include <algorithm>

#include "ice_ice_baby/parallel.h"

namespace ice_ice_baby {

namespace {

/// Within which a volume follows a change of phase, s.
constexpr double kSwelling_s = 0.5;

}  // namespace

template <class Real>
Phases<Real>::Phases(const Scene& scene, std::size_t particles)
    : freeze_below_c_(scene.heat.freezing_c - scene.heat.hysteresis_c),
      melt_above_c_(scene.heat.freezing_c + scene.heat.hysteresis_c),
      expansion_(1.0 / scene.ice.density_ratio - 1.0),
      elastic_(scene.ice.compliance_m_n > 0.0),
      phase_(particles, Phase::kWater),
      share_(particles, Real(1)),
      slush_(particles, Real(0)),
      steam_(particles, 0),
      flows_(particles, 1),
      wet_(particles, 1),
      new_ice_(particles, 0),
      stuck_to_(particles, kNone) {}

/// Water freezes once all its latent heat is gone and it is colder than it melts, ice melts once
/// all of it is back; steam likewise.
template <class Real>
Phase Phases<Real>::next(Phase phase, const EnthalpyCurve& curve, double enthalpy_j_kg) const {
  const double ice = curve.iceFraction(enthalpy_j_kg);
  const double steam = curve.steamFraction(enthalpy_j_kg);
  if (steam >= 1.0 || (phase == Phase::kSteam && steam > 0.0)) return Phase::kSteam;
  const double celsius = curve.temperature(enthalpy_j_kg);
  if (phase == Phase::kIce) {
    return ice > 0.0 || celsius < melt_above_c_ ? Phase::kIce : Phase::kWater;
  }
  return ice >= 1.0 && celsius <= freeze_below_c_ ? Phase::kIce : Phase::kWater;
}

template <class Real>
bool Phases<Real>::update(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg,
                          double dt_s) {
  const Real step = static_cast<Real>(std::min(1.0, dt_s / kSwelling_s));
  bool changed = false;
  ice_count_ = steam_count_ = 0;
  for (std::size_t i = 0; i < phase_.size(); ++i) {
    const Phase now = next(phase_[i], curve, enthalpy_j_kg[i]);
    new_ice_[i] = now == Phase::kIce && phase_[i] != Phase::kIce;
    changed |= now != phase_[i];
    if (now != Phase::kIce) stuck_to_[i] = kNone;
    phase_[i] = now;
    ice_count_ += now == Phase::kIce;
    steam_count_ += now == Phase::kSteam;
    steam_[i] = now == Phase::kSteam;
    flows_[i] = now == Phase::kWater || (elastic_ && now == Phase::kIce);
    const double fraction = curve.iceFraction(enthalpy_j_kg[i]);
    slush_[i] = now == Phase::kWater ? static_cast<Real>(fraction) : Real(0);
    const Real wanted = static_cast<Real>(1.0 + expansion_ * fraction);
    share_[i] =
        now == Phase::kSteam ? Real(0) : share_[i] + std::clamp(wanted - share_[i], -step, step);
  }
  return changed;
}

template <class Real>
void Phases<Real>::findWet(const Neighbours<Real>& neighbours) {
  parallelFor(phase_.size(), [&](std::size_t i) {
    wet_[i] = flows_[i];
    if (flows_[i] || steam_[i]) return;
    for (const Index j : neighbours.of(i)) {
      if (!flows_[j]) continue;
      wet_[i] = 1;
      return;
    }
  });
}

template <class Real>
void Phases<Real>::reorder(const std::vector<Index>& order) {
  permute(phase_, order, phase_scratch_);
  permute(share_, order, scratch_);
  permute(slush_, order, scratch_);
  permute(stuck_to_, order, index_scratch_);
  for (auto* flags : {&steam_, &flows_, &wet_, &new_ice_}) permute(*flags, order, flag_scratch_);
}

template <class Real>
std::size_t Phases<Real>::bytes() const {
  return (phase_.capacity() + phase_scratch_.capacity()) * sizeof(Phase) +
         (share_.capacity() + slush_.capacity() + scratch_.capacity()) * sizeof(Real) +
         (stuck_to_.capacity() + index_scratch_.capacity()) * sizeof(Index) + steam_.capacity() +
         flows_.capacity() + wet_.capacity() + new_ice_.capacity() + flag_scratch_.capacity();
}

template class Phases<float>;
template class Phases<double>;

}  // namespace ice_ice_baby
