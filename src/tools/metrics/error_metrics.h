// Error metrics of a run. Each scene has those that apply to it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frame_view.h"

namespace ice_ice_baby {

/// One number of the report. The unit is part of the name; without one it is a fraction. The ideal
/// is 0, except for heights and other plain measurements.
struct ErrorMetric {
  std::string name;
  double value;
};

/// Observes a run frame by frame and reports at the end.
class MetricRecorder {
 public:
  virtual ~MetricRecorder() = default;
  /// The first call passes the initial state.
  virtual void add(const FrameView& frame) = 0;
  /// Appends the metrics; none if the run was too short.
  virtual void report(std::vector<ErrorMetric>& metrics) const = 0;
};

/// The recorders that apply to this scene. `start` is the initial state.
std::vector<std::unique_ptr<MetricRecorder>> metricsFor(const FrameView& start);

}  // namespace ice_ice_baby
