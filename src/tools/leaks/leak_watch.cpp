#include "leaks/leak_watch.h"

#include <algorithm>
#include <utility>

namespace ice_ice_baby::leaks {

namespace {

/// Lattice of the distances that show which particles are far from all walls.
constexpr double kEdge_m = 0.005, kBand_m = 0.02;

}  // namespace

LeakWatch::LeakWatch(const Vessel& vessel, double spacing_m)
    : walls_(vessel.walls),
      room_(vessel.room),
      distance_(walls_, false, kEdge_m, kBand_m, 0.0),
      rim_m_(vessel.rim_m),
      spacing_m_(spacing_m),
      near_(walls_.bounds()) {
  near_.min() -= Vec3d::Constant(spacing_m);
  near_.max() += Vec3d::Constant(spacing_m);
}

bool LeakWatch::inRoom(const Vec3d& place) const {
  return room_.bounds().contains(place) && room_.encloses(place);
}

std::size_t LeakWatch::inside() const {
  return std::size_t(std::count_if(tracks_.begin(), tracks_.end(),
                                   [](const Track& t) { return t.present && t.inside; }));
}

void LeakWatch::start(const std::vector<ParticleSample>& samples, const Posed& pose) {
  for (const ParticleSample& s : samples) {
    if (tracks_.size() <= s.id) tracks_.resize(s.id + 1);
    Track& track = tracks_[s.id];
    track.place = pose.toLocal(Vec3d(s.x, s.y, s.z));
    track.present = true;
    track.inside = inRoom(track.place);
  }
}

/// Counts a path that ends at `place`.
void LeakWatch::follow(const ParticleSample& sample, const Vec3d& place, bool placed) {
  Track& track = tracks_[sample.id];
  const Vec3d from = track.place;
  track.place = place;
  track.present = true;
  const double way = (place - from).norm();
  const bool past_rim = rim_m_ && (from.z() < *rim_m_) != (place.z() < *rim_m_);
  if (!past_rim && distance_.atLeast(from) > way) return;
  const bool before = track.inside;
  track.inside = inRoom(place);
  if (track.inside == before || (placed && !before)) return;
  const double highest = std::max(from.z(), place.z());
  if (rim_m_ && highest > *rim_m_ - spacing_m_) return;
  if (!walls_.crosses(from, place)) return;
  track.leaked = true;
  ++counts_.through_wall;
  if (!counts_.first) counts_.first = LeakedPath{time_s_, sample.id, from, place};
}

void LeakWatch::frame(const std::vector<ParticleSample>& samples, const Posed& pose, double frame_s,
                      bool placed) {
  time_s_ += frame_s;
  std::vector<bool> there(tracks_.size(), false);
  for (const ParticleSample& s : samples) {
    there[s.id] = true;
    const Vec3d place = pose.toLocal(Vec3d(s.x, s.y, s.z));
    if (!place.allFinite()) {
      ++counts_.not_finite;
      continue;
    }
    if (near_.contains(place)) counts_.particle_seconds += frame_s;
    follow(s, place, placed);
  }
  for (std::size_t id = 0; id < tracks_.size(); ++id) {
    if (!there[id]) tracks_[id].present = false;
  }
}

/// All that is not inside an open vessel and did not leak left over the rim. What is not inside a
/// closed one leaked, however it got out.
LeakCounts LeakWatch::take() {
  for (Track& track : tracks_) {
    const bool inside = track.present && (rim_m_ ? track.inside : inRoom(track.place));
    if (inside || track.leaked) continue;
    ++(rim_m_ ? counts_.escaped_over_rim : counts_.through_wall);
    track.leaked = !rim_m_;
  }
  return std::exchange(counts_, {});
}

}  // namespace ice_ice_baby::leaks
