#include "ice_ice_baby/springs.h"

#include <algorithm>
#include <limits>

namespace ice_ice_baby {

SpringRange allowedRange(const SpringParams& params, double strictness, double dt_s) {
  const double slack = params.slack_1_s * (1.0 - strictness) * dt_s;
  return {std::max(0.0, 1.0 - slack), std::numeric_limits<double>::infinity()};
}

template <class Real>
Real springCorrection(Real length_m, Real rest_m, const SpringRange& range) {
  const Real shortest = rest_m * static_cast<Real>(range.shortest);
  const Real longest = rest_m * static_cast<Real>(range.longest);
  if (length_m < shortest) return length_m - shortest;
  if (length_m > longest) return length_m - longest;
  return 0;
}

template <class Real>
template <class Joined>
void Springs<Real>::join(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                         Real reach_m, const Joined& joined) {
  for (Index a = 0; a < particles.size(); ++a) {
    const Vec3<Real> xa = particles.position.at(a);
    for (const Index b : neighbours.of(a)) {
      if (b <= a || !joined(a, b)) continue;
      const Real length = (particles.position.at(b) - xa).norm();
      if (length <= reach_m) springs_.push_back({a, b, length});
    }
  }
}

template <class Real>
void Springs<Real>::addSheet(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                             const Spawn& sheet, Real reach_m) {
  const auto in_sheet = [&](Index i) { return particles.id[i] - sheet.first_id < sheet.count; };
  join(particles, neighbours, reach_m,
       [&](Index a, Index b) { return in_sheet(a) && in_sheet(b); });
  sheet_count_ = springs_.size();
}

template <class Real>
void Springs<Real>::make(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                         Real reach_m) {
  melt();
  join(particles, neighbours, reach_m, [](Index, Index) { return true; });
}

template <class Real>
void Springs<Real>::melt() {
  kept_ = false;
  springs_.resize(sheet_count_);
}

template <class Real>
void Springs<Real>::correct(VectorField<Real>& predicted, double strictness, double dt_s) const {
  const SpringRange rigid;
  const SpringRange ice_range = kept_ ? rigid : allowedRange(params_, strictness, dt_s);
  const auto correctOne = [&](std::size_t s) {
    const Spring<Real>& spring = springs_[s];
    const Vec3<Real> xa = predicted.at(spring.a);
    const Vec3<Real> xb = predicted.at(spring.b);
    const Vec3<Real> along = xb - xa;
    const Real length = along.norm();
    const SpringRange& range = s < sheet_count_ ? rigid : ice_range;
    const Real c = springCorrection(length, spring.rest_m, range);
    if (c == 0 || length == 0) return;
    const Vec3<Real> half = along * (c * Real(0.5) / length);
    predicted.set(spring.a, xa + half);
    predicted.set(spring.b, xb - half);
  };
  // One sweep carries errors along with it and shakes sheets apart; there and back it is symmetric.
  const std::size_t count = springs_.size();
  for (std::size_t s = 0; s < count; ++s) correctOne(s);
  for (std::size_t s = count; s-- > 0;) correctOne(s);
}

template <class Real>
void Springs<Real>::renumber(const std::vector<Index>& order) {
  place_of_.resize(order.size());
  for (Index k = 0; k < order.size(); ++k) place_of_[order[k]] = k;
  for (Spring<Real>& spring : springs_) {
    spring.a = place_of_[spring.a];
    spring.b = place_of_[spring.b];
  }
}

template <class Real>
std::size_t Springs<Real>::bytes() const {
  return springs_.capacity() * sizeof(Spring<Real>) + place_of_.capacity() * sizeof(Index);
}

template class Springs<float>;
template class Springs<double>;
template float springCorrection(float, float, const SpringRange&);
template double springCorrection(double, double, const SpringRange&);

}  // namespace ice_ice_baby
