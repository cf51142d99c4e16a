#include "ice/springs.h"

#include <algorithm>
#include <limits>
#include <numeric>

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
                         const Phases<Real>* phases, Real reach_m) {
  melt();
  join(particles, neighbours, reach_m,
       [&](Index a, Index b) { return !phases || !(phases->solid(a) || phases->solid(b)); });
}

template <class Real>
void Springs<Real>::melt() {
  kept_ = false;
  springs_.resize(sheet_count_);
  multipliers_.resize(std::min(multipliers_.size(), sheet_count_));
}

template <class Real>
void Springs<Real>::freeze(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                           const Phases<Real>& phases, Real reach_m,
                           const std::vector<Spawn>* apart) {
  const auto spawnOf = [&](Index i) {
    const auto after = [](std::uint32_t id, const Spawn& spawn) { return id < spawn.first_id; };
    return std::upper_bound(apart->begin(), apart->end(), particles.id[i], after);
  };
  for (Index a = 0; a < particles.size(); ++a) {
    if (!phases.newIce(a)) continue;
    const Vec3<Real> xa = particles.position.at(a);
    for (const Index b : neighbours.of(a)) {
      if (!phases.ice(b) || (phases.newIce(b) && b < a)) continue;
      if (apart && spawnOf(a) != spawnOf(b)) continue;
      const Real length = (particles.position.at(b) - xa).norm();
      if (length <= reach_m) springs_.push_back({a, b, length});
    }
  }
}

template <class Real>
void Springs<Real>::joinNew(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                            const Phases<Real>* phases, Real reach_m, std::uint32_t first_id) {
  join(particles, neighbours, reach_m, [&](Index a, Index b) {
    if (phases && (phases->solid(a) || phases->solid(b))) return false;
    return particles.id[a] >= first_id || particles.id[b] >= first_id;
  });
}

/// Multipliers are those of the first springs.
template <class Real>
template <class Broken>
void Springs<Real>::breakFrom(std::size_t first, const Broken& broken) {
  std::size_t kept = first, with_multiplier = std::min(first, multipliers_.size());
  for (std::size_t s = first; s < springs_.size(); ++s) {
    if (broken(springs_[s])) continue;
    if (s < multipliers_.size()) multipliers_[with_multiplier++] = multipliers_[s];
    springs_[kept++] = springs_[s];
  }
  springs_.resize(kept);
  multipliers_.resize(with_multiplier);
}

template <class Real>
void Springs<Real>::removeOf(const std::vector<char>& gone) {
  const auto broken = [&](const Spring<Real>& s) { return gone[s.a] || gone[s.b]; };
  const auto sheets_end = springs_.begin() + std::ptrdiff_t(sheet_count_);
  const auto of_sheets = std::count_if(springs_.begin(), sheets_end, broken);
  breakFrom(0, broken);
  sheet_count_ -= static_cast<std::size_t>(of_sheets);
}

template <class Real>
void Springs<Real>::breakMelted(const Phases<Real>& phases) {
  breakFrom(sheet_count_,
            [&](const Spring<Real>& s) { return !phases.ice(s.a) || !phases.ice(s.b); });
}

/// Union by the smaller index, with path halving.
template <class Real>
void Springs<Real>::labelBodies(const Phases<Real>& phases, std::vector<Index>& labels) const {
  const auto rootOf = [&](Index i) {
    while (labels[i] != i) i = labels[i] = labels[labels[i]];
    return i;
  };
  labels.resize(phases.size());
  std::iota(labels.begin(), labels.end(), Index(0));
  for (std::size_t s = sheet_count_; s < springs_.size(); ++s) {
    const Index a = rootOf(springs_[s].a), b = rootOf(springs_[s].b);
    labels[std::max(a, b)] = std::min(a, b);
  }
  for (Index i = 0; i < labels.size(); ++i) labels[i] = phases.ice(i) ? rootOf(i) : kNone;
}

template <class Real>
void Springs<Real>::correct(VectorField<Real>& predicted, double strictness, double particle_kg,
                            double dt_s, bool begins) {
  // Springs that are rebuilt in every substep store no energy.
  const std::size_t lasting = kept_ ? springs_.size() : sheet_count_;
  if (begins) multipliers_.assign(lasting, Real(0));
  const Real half_mass = static_cast<Real>(0.5 * particle_kg);
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
    if (s < lasting) multipliers_[s] -= half_mass * c;
    const Vec3<Real> half = along * (c * Real(0.5) / length);
    predicted.set(spring.a, xa + half);
    predicted.set(spring.b, xb - half);
  };
  // A one-way sweep carries errors in its direction and destabilises sheets; both ways is
  // symmetric.
  const std::size_t count = springs_.size();
  for (std::size_t s = 0; s < count; ++s) correctOne(s);
  for (std::size_t s = count; s-- > 0;) correctOne(s);
}

template <class Real>
void Springs<Real>::correctElastic(VectorField<Real>& predicted, double compliance_m_n,
                                   double particle_kg, double dt_s, bool begins) {
  if (begins) multipliers_.assign(springs_.size(), Real(0));
  const Real softness = static_cast<Real>(compliance_m_n / (dt_s * dt_s));  // 1/kg
  const Real inverse_mass = static_cast<Real>(1.0 / particle_kg);
  const auto correctOne = [&](std::size_t s) {
    const Spring<Real>& spring = springs_[s];
    const Vec3<Real> along = predicted.at(spring.b) - predicted.at(spring.a);
    const Real length = along.norm();
    if (length == 0) return;
    const Real c = length - spring.rest_m;
    const Real change = (-c - softness * multipliers_[s]) / (2 * inverse_mass + softness);
    multipliers_[s] += change;
    const Vec3<Real> move = along * (change * inverse_mass / length);
    predicted.add(spring.a, -move);
    predicted.add(spring.b, move);
  };
  const std::size_t count = springs_.size();
  for (std::size_t s = 0; s < count; ++s) correctOne(s);
  for (std::size_t s = count; s-- > 0;) correctOne(s);
}

template <class Real>
void Springs<Real>::breakStretched(const VectorField<Real>& position, double strain) {
  const Real max = static_cast<Real>(1.0 + strain);
  breakFrom(sheet_count_, [&](const Spring<Real>& s) {
    return (position.at(s.b) - position.at(s.a)).norm() > max * s.rest_m;
  });
}

template <class Real>
double Springs<Real>::elasticEnergy_j(const VectorField<Real>& position, double dt_s) const {
  double sum = 0.0;
  for (std::size_t s = 0; s < multipliers_.size(); ++s) {
    if (multipliers_[s] == 0) continue;
    const double length = (position.at(springs_[s].b) - position.at(springs_[s].a)).norm();
    sum -= double(multipliers_[s]) * (length - double(springs_[s].rest_m));
  }
  return 0.5 * sum / (dt_s * dt_s);
}

template <class Real>
void Springs<Real>::renumber(const std::vector<Index>& order) {
  if (order.empty()) return;
  place_of_.resize(1 + *std::max_element(order.begin(), order.end()));
  for (Index k = 0; k < order.size(); ++k) place_of_[order[k]] = k;
  for (Spring<Real>& spring : springs_) {
    spring.a = place_of_[spring.a];
    spring.b = place_of_[spring.b];
  }
}

template <class Real>
std::size_t Springs<Real>::bytes() const {
  return springs_.capacity() * sizeof(Spring<Real>) + multipliers_.capacity() * sizeof(Real) +
         place_of_.capacity() * sizeof(Index);
}

template class Springs<float>;
template class Springs<double>;
template float springCorrection(float, float, const SpringRange&);
template double springCorrection(double, double, const SpringRange&);

}  // namespace ice_ice_baby
