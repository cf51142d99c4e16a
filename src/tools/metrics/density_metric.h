// Compression, by the solver's own kernel and by the cubic spline that all solvers are compared by.
#pragma once

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// Means over the frames; the start, which no setting has touched, is left out.
class DensityMetric final : public MetricRecorder {
 public:
  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  DensityError cubic_, own_;  ///< sums
  std::size_t frames_ = 0;
};

}  // namespace ice_ice_baby
