// Energy that a run gains or loses.
#pragma once

#include <cstdint>
#include <limits>

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// Both metrics are relative to the energy available at the start: potential energy above the
/// lowest point plus kinetic energy. This scale depends on the scene alone, so settings can be
/// compared; a scale taken from the run itself would favour settings that shake.
///
/// `energy_drift`: total at the end minus total at the start. Water that splashes loses energy, so
/// only its sign and its change between settings matter. `energy_rise`: the largest rise of the
/// total above its running minimum. No work is done on the water, so the ideal is 0. The total is
/// the sum of kinetic, potential and elastic energy, so the rebound of compressed water is no rise.
/// The change in a frame in which particles came or left does not count.
class EnergyMetric final : public MetricRecorder {
 public:
  /// Null for a scene without water or without available energy.
  static std::unique_ptr<EnergyMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  explicit EnergyMetric(double scale_j) : scale_j_(scale_j) {}

  double scale_j_;
  double start_j_ = std::numeric_limits<double>::quiet_NaN();
  double end_j_ = 0.0;
  double min_j_ = std::numeric_limits<double>::max();
  double rise_j_ = 0.0;
  std::uint64_t moved_ = 0;  ///< particles that came and left so far
};

}  // namespace ice_ice_baby
