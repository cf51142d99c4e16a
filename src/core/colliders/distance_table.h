// Tabulated function of the distance to a surface.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace ice_ice_baby {

/// Tabulated from 0 to a maximum distance; 0 beyond.
template <class Real>
class DistanceTable {
 public:
  DistanceTable() = default;

  /// @param function of a distance in m
  template <class Function>
  DistanceTable(double reach_m, const Function& function)
      : per_m_(static_cast<Real>(kSize / reach_m)) {
    values_.reserve(kSize + 2);
    for (int k = 0; k <= kSize; ++k) {
      values_.push_back(static_cast<Real>(function(reach_m * k / kSize)));
    }
    values_.push_back(0);
  }

  /// Value and slope at a distance; negative distances count as 0.
  std::pair<Real, Real> at(Real distance_m) const {
    const Real place = std::max(distance_m, Real(0)) * per_m_;
    if (!(place < kSize)) return {0, 0};
    const auto k = static_cast<std::size_t>(place);
    const Real rise = values_[k + 1] - values_[k];
    return {values_[k] + (place - static_cast<Real>(k)) * rise, rise * per_m_};
  }

  std::size_t bytes() const { return values_.capacity() * sizeof(Real); }

 private:
  static constexpr int kSize = 512;

  std::vector<Real> values_;
  Real per_m_ = 0;
};

}  // namespace ice_ice_baby
