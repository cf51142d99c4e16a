// Compression, measured with the solver's own kernel and with the reference cubic spline.
#pragma once

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// Means over the frames without the initial state, which does not depend on the settings.
class DensityMetric final : public MetricRecorder {
 public:
  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  DensityError cubic_, own_;  ///< sums
  std::size_t frames_ = 0;
};

}  // namespace ice_ice_baby
