// When ice bodies sleep and wake.
#include <algorithm>

#include "base/parallel.h"
#include "ice/ice_bodies.h"

namespace ice_ice_baby {

namespace {

/// How long a body must have been slow before it sleeps.
constexpr double kStill_s = 0.5;

}  // namespace

/// Whether any member of a body touches water.
template <class Real>
bool IceBodies<Real>::isWet(const IceBody& body, const std::vector<std::uint8_t>& wet) const {
  if (wet.empty()) return false;
  const auto begin = place_.begin();
  return std::any_of(begin + body.first, begin + body.surface_last,
                     [&](Index i) { return wet[i] != 0; });
}

/// Bodies in contact sleep together, because a sleeping body exerts no weight on those below.
template <class Real>
void IceBodies<Real>::updateSleep(const std::vector<std::uint8_t>& wet, double time_s) {
  islands_.assign(bodies_.size(), {kStill_s, false});
  parallelFor(bodies_.size(), [&](std::size_t b) {
    IceBody& body = bodies_[b];
    if (body.carried()) return;
    const bool calm = body.asleep || body.speed_m_s < sleep_speed_m_s_;
    body.still_s = calm && !isWet(body, wet) ? body.still_s + time_s : 0.0;
    if (body.still_s == 0.0) body.asleep = false;
  });
  const auto islandOf = [&](Index b) -> Island& {
    return islands_[bodies_[b].island < bodies_.size() ? bodies_[b].island : b];
  };
  for (Index b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].held()) continue;
    Island& island = islandOf(b);
    island.still_s = std::min(island.still_s, bodies_[b].still_s);
    island.supported = island.supported || bodies_[b].supported;
  }
  for (Index b = 0; b < bodies_.size(); ++b) {
    const Island& island = islandOf(b);
    if (bodies_[b].held() || !island.supported || island.still_s < kStill_s) continue;
    bodies_[b].asleep = true;
    bodies_[b].stop();
  }
}

template <class Real>
void IceBodies<Real>::wakeAll() {
  for (IceBody& body : bodies_) {
    body.asleep = false;
    body.still_s = 0.0;
  }
}

template <class Real>
void IceBodies<Real>::stopAll() {
  for (IceBody& body : bodies_) body.stop();
}

template <class Real>
void IceBodies<Real>::wakeInFlight(Index b) {
  bodies_[b].asleep = false;
  bodies_[b].still_s = 0.0;
  fly(bodies_[b]);
}

template <class Real>
std::size_t IceBodies<Real>::asleep(bool solid) const {
  return static_cast<std::size_t>(std::count_if(
      bodies_.begin(), bodies_.end(),
      [&](const IceBody& body) { return body.asleep && (body.solid != kNone) == solid; }));
}

template class IceBodies<float>;
template class IceBodies<double>;

}  // namespace ice_ice_baby
