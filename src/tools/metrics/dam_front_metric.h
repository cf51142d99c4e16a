// Front of a dam break compared with the experiment of Martin and Moyce.
#pragma once

#include "metrics/error_metrics.h"
#include "metrics/martin_moyce.h"

namespace ice_ice_baby {

/// For one block of water at rest, twice as high as wide in x, that stands against the lower x wall
/// of an upright container and reaches from wall to wall in y, with room for the front to run, as
/// in the experiment. The front is half a spacing ahead of the foremost particle. `front_error`
/// compares with the wider of the two columns measured, or the narrow one if the scene's is as
/// small.
class DamFrontMetric final : public MetricRecorder {
 public:
  static std::unique_ptr<DamFrontMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  double wall_x_m_ = 0.0;
  double width_m_ = 0.0;
  double gravity_m_s2_ = 0.0;
  std::vector<FrontPoint> run_;
};

}  // namespace ice_ice_baby
