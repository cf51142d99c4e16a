#include "metrics/ice_metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "metrics/cloud_moments.h"
#include "metrics/rigid_fit.h"

namespace ice_ice_baby {

namespace {

bool everFreezes(const Scene& scene) {
  double coldest_c = scene.temperature.initial_c;
  for (const TemperatureEvent& event : scene.schedule) {
    coldest_c = std::min(coldest_c, event.celsius);
  }
  return coldest_c <= scene.temperature.freezing_c;
}

std::vector<Vec3d> positionsOf(const std::vector<ParticleSample>& particles) {
  std::vector<Vec3d> positions(particles.size());
  std::transform(particles.begin(), particles.end(), positions.begin(), positionOf);
  return positions;
}

using Point = std::array<float, 3>;

/// Places of the ends of every spring among the samples. Spring samples contain positions only,
/// which are bit-identical to those of the particle samples.
std::vector<std::pair<std::size_t, std::size_t>> joinedPlaces(const FrameView& frame) {
  std::map<Point, std::size_t> places;
  for (std::size_t k = 0; k < frame.particles.size(); ++k) {
    const ParticleSample& p = frame.particles[k];
    places[{p.x, p.y, p.z}] = k;
  }
  std::vector<SpringSample> springs;
  frame.simulation.sampleSprings(springs, frame.report().springs);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  pairs.reserve(springs.size());
  for (const SpringSample& s : springs) {
    pairs.emplace_back(places.at({s.ax, s.ay, s.az}), places.at({s.bx, s.by, s.bz}));
  }
  return pairs;
}

}  // namespace

IceMetric::IceMetric(const Scene& scene)
    : spacing_m_(scene.fluid.spacing_m),
      window_(std::size_t(std::max(1.0, 0.5 * scene.solver.frame_rate_hz))) {}

std::unique_ptr<IceMetric> IceMetric::forScene(const FrameView& start) {
  const auto& blocks = start.scene().blocks;
  const bool water =
      std::any_of(blocks.begin(), blocks.end(), [](const Block& b) { return !b.sheet; });
  if (!water || start.particles.empty() || !everFreezes(start.scene())) return nullptr;
  return std::unique_ptr<IceMetric>(new IceMetric(start.scene()));
}

void IceMetric::add(const FrameView& frame) {
  if (frame.report().strictness < 1.0) {
    // Ice that froze again is a new piece; only the last one is reported.
    if (!melted_) melted_ = !frozen_.empty();
    return;
  }
  // Ice of which particles spilled is a new piece, too.
  if (frozen_.empty() || melted_ || frame.particles.size() != frozen_.size()) {
    frozen_ = positionsOf(frame.particles);
    pieces_ = connectedGroups(frozen_.size(), joinedPlaces(frame));
    speeds_m_s_.clear();
    melted_ = false;
  }
  last_ = positionsOf(frame.particles);
  speeds_m_s_.push_back(frame.report().rms_speed_m_s);
}

double IceMetric::drift_m() const {
  double squares = 0.0;
  for (const auto& piece : pieces_) {
    squares += squaredRigidMisfit_m2(frozen_, last_, piece);
  }
  return std::sqrt(squares / double(frozen_.size()));
}

void IceMetric::report(std::vector<ErrorMetric>& metrics) const {
  if (speeds_m_s_.size() < 2) return;
  metrics.push_back({"ice_drift_spacings", drift_m() / spacing_m_});
  if (speeds_m_s_.size() <= window_) return;
  double squares = 0.0;
  for (std::size_t k = speeds_m_s_.size() - window_; k < speeds_m_s_.size(); ++k) {
    squares += speeds_m_s_[k] * speeds_m_s_[k];
  }
  metrics.push_back({"ice_residual_speed_m_s", std::sqrt(squares / double(window_))});
}

}  // namespace ice_ice_baby
