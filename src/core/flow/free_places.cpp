#include "flow/free_places.h"

namespace ice_ice_baby {

namespace {

/// Rounding error of a push by a collider, as a fraction of its length.
constexpr double kRounding = 1e-3;

/// Drops move aside by at most this, in spacings.
constexpr double kAside_d = 0.5 * (1 + kRounding);

}  // namespace

template <class Real>
FreePlaces<Real>::FreePlaces(const Colliders<Real>& colliders, const Particles<Real>& particles,
                             double spacing_m, const std::vector<Drop>& drops)
    : colliders_(colliders), spacing_m_(spacing_m), taken_(kKeptApart_d * spacing_m) {
  Eigen::AlignedBox3d box;
  for (const Drop& drop : drops) box.extend(drop.position_m);
  const Vec3d margin = Vec3d::Constant((kKeptApart_d + kAside_d) * spacing_m);
  const Eigen::AlignedBox3d around(box.min() - margin, box.max() + margin);
  for (Index i = 0; i < particles.size(); ++i) {
    const Vec3d x = particles.position.at(i).template cast<double>();
    if (around.contains(x)) taken_.add(x, i);
  }
}

template <class Real>
bool FreePlaces<Real>::take(Drop& drop, std::vector<Index>& in_the_way) {
  in_the_way.clear();
  if (!colliders_.empty()) {
    const std::optional<Vec3d> place = beside(drop.from_m, drop.position_m);
    if (!place || !beside(drop.from_m, drop.site_m)) return false;
    drop.position_m = *place;
  }
  bool free = true;
  taken_.forEachNear(drop.position_m, kKeptApart_d * spacing_m_, [&](std::size_t other) {
    free = false;
    if (other != kNone) in_the_way.push_back(static_cast<Index>(other));
  });
  if (free) taken_.add(drop.position_m, kNone);
  return free;
}

/// End of the way, at most a particle radius aside where solids are close; none if a solid lies in
/// the way.
template <class Real>
std::optional<Vec3d> FreePlaces<Real>::beside(const Vec3d& from_m, const Vec3d& to_m) const {
  const Vec3<Real> to = to_m.template cast<Real>();
  const Vec3<Real> end = colliders_.respond(from_m.template cast<Real>(), to, false);
  if (end == to) return to_m;
  if (double((end - to).norm()) > kAside_d * spacing_m_) return std::nullopt;
  return end.template cast<double>();
}

template class FreePlaces<float>;
template class FreePlaces<double>;

}  // namespace ice_ice_baby
