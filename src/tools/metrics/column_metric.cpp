#include "metrics/column_metric.h"

#include <algorithm>
#include <numeric>

#include "metrics/block_in_container.h"

namespace ice_ice_baby {

std::unique_ptr<ColumnMetric> ColumnMetric::forScene(const FrameView& start) {
  const auto block = blockInContainer(start);
  if (!block || start.particles.empty()) return nullptr;
  const double little_m = 0.25 * start.scene().fluid.spacing_m;
  const bool fills =
      block->min_gap_m.maxCoeff() < little_m && block->max_gap_m.head<2>().maxCoeff() < little_m;
  if (!fills) return nullptr;
  const auto window = std::size_t(std::max(1.0, 0.5 * start.scene().solver.frame_rate_hz));
  return std::unique_ptr<ColumnMetric>(new ColumnMetric(block->floor_m.z(), window));
}

void ColumnMetric::add(const FrameView& frame) {
  double sum = 0.0;
  for (const ParticleSample& p : frame.particles) sum += double(p.z);
  const double height_m = 2 * (sum / double(frame.particles.size()) - floor_m_);
  if (frame.report().frame == 0) {
    start_m_ = height_m;
    return;
  }
  heights_m_.push_back(height_m);
  if (heights_m_.size() > window_) heights_m_.pop_front();
}

void ColumnMetric::report(std::vector<ErrorMetric>& metrics) const {
  if (heights_m_.empty()) return;
  const double height_m =
      std::accumulate(heights_m_.begin(), heights_m_.end(), 0.0) / double(heights_m_.size());
  metrics.push_back({"column_height_m", height_m});
  metrics.push_back({"column_height_lost", 1.0 - height_m / start_m_});
}

}  // namespace ice_ice_baby
