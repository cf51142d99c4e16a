#include "measure/vessel_tracker.h"

namespace ice_ice_baby {

template <class Real>
VesselTracker<Real>::VesselTracker(const Scene& scene, const Particles<Real>& particles,
                                   const Colliders<Real>& colliders, const Spawn& solids,
                                   double time_s)
    : vessels_(scene),
      solids_(solids),
      where_(vessels_.groups()),
      inside_(vessels_.size()),
      totals_(vessels_.size()) {
  for (auto& where : where_) where.assign(particles.size(), kNoVessel);
  observe(particles, colliders);
  totals_.assign(vessels_.size(), {});
  endFrame(time_s);
}

template <class Real>
void VesselTracker<Real>::add(std::size_t count) {
  for (auto& where : where_) where.resize(where.size() + count, kNoVessel);
}

template <class Real>
void VesselTracker<Real>::reorder(const std::vector<Index>& order) {
  for (auto& where : where_) permute(where, order, scratch_);
}

template <class Real>
void VesselTracker<Real>::observe(const Particles<Real>& particles,
                                  const Colliders<Real>& colliders) {
  for (std::size_t group = 0; group < where_.size(); ++group) {
    vessels_.locate(group, particles.position, colliders, now_);
    for (std::size_t i = 0; solids_.count > 0 && i < now_.size(); ++i) {
      if (particles.id[i] - solids_.first_id < solids_.count) now_[i] = kNoVessel;
    }
    compare(group, now_);
    where_[group].swap(now_);
  }
}

/// Particles that were removed from the scene have no place in the lists. They are those that are
/// missing from the sum.
template <class Real>
void VesselTracker<Real>::compare(std::size_t group, const std::vector<VesselNumber>& now) {
  const std::vector<VesselNumber>& before = where_[group];
  std::vector<std::uint64_t> stayed(vessels_.size()), inside(vessels_.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == kNoVessel) continue;
    ++inside[now[i]];
    if (now[i] == before[i]) ++stayed[now[i]];
  }
  for (const VesselNumber number : vessels_.group(group)) {
    totals_[number].entered += inside[number] - stayed[number];
    totals_[number].left += inside_[number] - stayed[number];
    inside_[number] = inside[number];
  }
}

template <class Real>
void VesselTracker<Real>::endFrame(double time_s) {
  moments_.push_back({time_s, totals_});
  constexpr double kHair_s = 1e-9;
  while (moments_.size() > 2 && moments_[1].time_s <= time_s - kWindow_s + kHair_s) {
    moments_.pop_front();
  }
}

template <class Real>
typename VesselTracker<Real>::Rates VesselTracker<Real>::rates(std::size_t vessel) const {
  const Moment &first = moments_.front(), &last = moments_.back();
  const double time_s = last.time_s - first.time_s;
  if (time_s <= 0.0) return {};
  const Totals &then = first.totals[vessel], &now = last.totals[vessel];
  return {double(now.entered - then.entered) / time_s, double(now.left - then.left) / time_s};
}

template <class Real>
std::size_t VesselTracker<Real>::bytes() const {
  std::size_t bytes = (now_.capacity() + scratch_.capacity()) * sizeof(VesselNumber);
  for (const auto& where : where_) bytes += where.capacity() * sizeof(VesselNumber);
  return bytes + moments_.size() * (sizeof(Moment) + vessels_.size() * sizeof(Totals));
}

template class VesselTracker<float>;
template class VesselTracker<double>;

}  // namespace ice_ice_baby
