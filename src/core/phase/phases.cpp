#include "phase/phases.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Time over which a volume follows a change of phase, s.
constexpr double kSwelling_s = 0.5;

}  // namespace

template <class Real>
Phases<Real>::Phases(const Scene& scene, std::size_t particles)
    : freeze_below_c_(scene.thermal.freezing_c - scene.thermal.hysteresis_c),
      melt_above_c_(scene.thermal.freezing_c + scene.thermal.hysteresis_c),
      expansion_(1.0 / scene.ice.density_ratio - 1.0),
      elastic_(scene.ice.compliance_m_n > 0.0),
      phase_(particles, Phase::kWater),
      relative_volume_(particles, Real(1)),
      target_volume_(particles, Real(1)),
      slush_(particles, Real(0)),
      steam_(particles, 0),
      flows_(particles, 1),
      wet_(particles, 1),
      pressed_(particles, 1),
      new_ice_(particles, 0),
      stuck_to_(particles, kNone) {}

template <class Real>
void Phases<Real>::makeSolid(std::size_t first, const std::vector<double>& volumes) {
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    phase_[first + k] = Phase::kSolid;
    relative_volume_[first + k] = target_volume_[first + k] = static_cast<Real>(volumes[k]);
    flows_[first + k] = 0;
  }
}

template <class Real>
void Phases<Real>::add(std::size_t count) {
  const std::size_t n = phase_.size() + count;
  relative_volume_.resize(n, Real(1));
  target_volume_.resize(n, Real(1));
  resizeAsWater(n);
}

template <class Real>
void Phases<Real>::resizeAsWater(std::size_t n) {
  phase_.resize(n, Phase::kWater);
  slush_.resize(n, Real(0));
  stuck_to_.resize(n, kNone);
  for (auto* flags : {&steam_, &new_ice_}) flags->resize(n, 0);
  for (auto* flags : {&flows_, &wet_, &pressed_}) flags->resize(n, 1);
}

template <class Real>
void Phases<Real>::add(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg) {
  for (std::size_t i = phase_.size(); i < enthalpy_j_kg.size(); ++i) {
    const bool steam = curve.steamFraction(enthalpy_j_kg[i]) >= 1.0;
    const double ice = curve.iceFraction(enthalpy_j_kg[i]);
    const Real volume = steam ? Real(0) : static_cast<Real>(1.0 + expansion_ * ice);
    relative_volume_.push_back(volume);
    target_volume_.push_back(volume);
  }
  resizeAsWater(enthalpy_j_kg.size());
}

/// Water freezes once it has lost all its latent heat, is colder than the hysteresis and has
/// expanded. Ice melts once it has regained that heat. Steam likewise.
template <class Real>
Phase Phases<Real>::next(std::size_t i, const EnthalpyCurve& curve, double enthalpy_j_kg) const {
  const double ice = curve.iceFraction(enthalpy_j_kg);
  const double steam = curve.steamFraction(enthalpy_j_kg);
  if (steam >= 1.0 || (steam_[i] && steam > 0.0)) return Phase::kSteam;
  const double celsius = curve.temperature(enthalpy_j_kg);
  if (phase_[i] == Phase::kIce) {
    return ice > 0.0 || celsius < melt_above_c_ ? Phase::kIce : Phase::kWater;
  }
  const bool swollen = relative_volume_[i] == static_cast<Real>(1.0 + expansion_);
  return swollen && ice >= 1.0 && celsius <= freeze_below_c_ ? Phase::kIce : Phase::kWater;
}

template <class Real>
bool Phases<Real>::update(const EnthalpyCurve& curve, const std::vector<double>& enthalpy_j_kg) {
  bool changed = false;
  ice_count_ = steam_count_ = 0;
  for (std::size_t i = 0; i < phase_.size(); ++i) {
    if (solid(i)) continue;
    const Phase now = next(i, curve, enthalpy_j_kg[i]);
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
    target_volume_[i] = steam_[i] ? Real(0) : static_cast<Real>(1.0 + expansion_ * fraction);
    if (steam_[i]) relative_volume_[i] = 0;
    swelling_ |= relative_volume_[i] != target_volume_[i];
  }
  return changed;
}

template <class Real>
void Phases<Real>::swell(double dt_s) {
  if (!swelling_) return;
  const double done = std::min(1.0, dt_s / kSwelling_s);
  const Real freezing = static_cast<Real>(std::abs(expansion_) * done);
  const Real condensing = static_cast<Real>(done);
  swelling_ = false;
  for (std::size_t i = 0; i < relative_volume_.size(); ++i) {
    const Real way = target_volume_[i] - relative_volume_[i];
    if (way == 0) continue;
    // A volume far from those of water and ice means that the particle was steam.
    const Real step = std::abs(way) > 2 * Real(std::abs(expansion_)) ? condensing : freezing;
    const bool there = std::abs(way) <= step;
    relative_volume_[i] =
        there ? target_volume_[i] : relative_volume_[i] + std::copysign(step, way);
    swelling_ |= !there;
  }
}

template <class Real>
void Phases<Real>::findWet(const Neighbours<Real>& neighbours) {
  const auto beside = [&](const std::vector<std::uint8_t>& marked, std::size_t i) {
    const auto list = neighbours.of(i);
    return std::any_of(list.begin(), list.end(), [&](Index j) { return marked[j] != 0; });
  };
  parallelFor(phase_.size(),
              [&](std::size_t i) { wet_[i] = flows_[i] || (!steam_[i] && beside(flows_, i)); });
  parallelFor(phase_.size(),
              [&](std::size_t i) { pressed_[i] = wet_[i] || (!steam_[i] && beside(wet_, i)); });
}

template <class Real>
void Phases<Real>::reorder(const std::vector<Index>& order) {
  permute(phase_, order, phase_scratch_);
  permute(relative_volume_, order, scratch_);
  permute(target_volume_, order, scratch_);
  permute(slush_, order, scratch_);
  permute(stuck_to_, order, index_scratch_);
  for (auto* flags : {&steam_, &flows_, &wet_, &pressed_, &new_ice_})
    permute(*flags, order, flag_scratch_);
}

template <class Real>
std::size_t Phases<Real>::bytes() const {
  return (phase_.capacity() + phase_scratch_.capacity()) * sizeof(Phase) +
         (relative_volume_.capacity() + target_volume_.capacity() + slush_.capacity() +
          scratch_.capacity()) *
             sizeof(Real) +
         (stuck_to_.capacity() + index_scratch_.capacity()) * sizeof(Index) + steam_.capacity() +
         flows_.capacity() + wet_.capacity() + pressed_.capacity() + pressed_.capacity() +
         new_ice_.capacity() + flag_scratch_.capacity();
}

template class Phases<float>;
template class Phases<double>;

}  // namespace ice_ice_baby
