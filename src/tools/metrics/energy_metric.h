// Energy that a run gains or loses.
#pragma once

#include <limits>

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// Both metrics are relative to the energy that the water could turn into motion at the start: its
/// weight times its height, plus its kinetic energy. That scale belongs to the scene, so settings
/// can be compared by it; a range that the run itself shows would flatter the setting that shakes.
///
/// `energy_drift`: total at the end less that at the start. Water that splashes loses energy, so
/// only its sign and its change between settings tell. `energy_rise`: the furthest that the total
/// was above its own running minimum. Nothing works on the water, so it may not rise: 0 is ideal.
/// The total is kinetic, potential and elastic: what compressed water gives back is no rise.
class EnergyMetric final : public MetricRecorder {
 public:
  /// Nothing for a scene without water or without any energy to turn into motion.
  static std::unique_ptr<EnergyMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  explicit EnergyMetric(double scale_j) : scale_j_(scale_j) {}

  double scale_j_;
  double start_j_ = std::numeric_limits<double>::quiet_NaN();
  double end_j_ = 0.0;
  double least_j_ = std::numeric_limits<double>::max();
  double rise_j_ = 0.0;
};

}  // namespace ice_ice_baby
