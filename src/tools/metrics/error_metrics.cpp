#include "metrics/error_metrics.h"

#include "metrics/column_metric.h"
#include "metrics/dam_front_metric.h"
#include "metrics/density_metric.h"
#include "metrics/energy_metric.h"
#include "metrics/ice_metric.h"

namespace ice_ice_baby {

std::vector<std::unique_ptr<MetricRecorder>> metricsFor(const FrameView& start) {
  std::vector<std::unique_ptr<MetricRecorder>> recorders;
  const auto add = [&](std::unique_ptr<MetricRecorder> recorder) {
    if (recorder) recorders.push_back(std::move(recorder));
  };
  add(std::make_unique<DensityMetric>());
  add(EnergyMetric::forScene(start));
  add(ColumnMetric::forScene(start));
  add(DamFrontMetric::forScene(start));
  add(IceMetric::forScene(start));
  for (const auto& recorder : recorders) recorder->add(start);
  return recorders;
}

}  // namespace ice_ice_baby
