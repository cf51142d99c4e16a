// Loss of height of a column of water at rest.
#pragma once

#include <deque>

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// For one block of water at rest that fills an upright container from wall to wall and stands on
/// its floor. It should neither sink nor rise. Its height is twice that of its centre of mass above
/// the floor, which ripples and drops hardly affect; mean over the last half second.
class ColumnMetric final : public MetricRecorder {
 public:
  static std::unique_ptr<ColumnMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  ColumnMetric(double floor_m, std::size_t window) : floor_m_(floor_m), window_(window) {}

  double floor_m_;
  std::size_t window_;  ///< frames
  double start_m_ = 0.0;
  std::deque<double> heights_m_;
};

}  // namespace ice_ice_baby
