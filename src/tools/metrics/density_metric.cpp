#include "metrics/density_metric.h"

namespace ice_ice_baby {

void DensityMetric::add(const FrameView& frame) {
  if (frame.report().frame == 0) return;
  ++frames_;
  cubic_.mean += frame.error.mean;
  cubic_.max += frame.error.max;
  cubic_.volume_lost += frame.error.volume_lost;
  own_.mean += frame.report().density_error_mean;
  own_.max += frame.report().density_error_max;
}

void DensityMetric::report(std::vector<ErrorMetric>& metrics) const {
  if (frames_ == 0) return;
  const double n = double(frames_);
  metrics.push_back({"density_mean", cubic_.mean / n});
  metrics.push_back({"density_max", cubic_.max / n});
  metrics.push_back({"own_density_mean", own_.mean / n});
  metrics.push_back({"own_density_max", own_.max / n});
  metrics.push_back({"volume_lost", cubic_.volume_lost / n});
}

}  // namespace ice_ice_baby
