// The metrics of a run's error, each only where the scene has it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frame_view.h"

namespace ice_ice_baby {

/// One number of the report; its unit is in its name, without one it is a fraction. 0 is ideal,
/// but for lengths and speeds that are named as such.
struct ErrorMetric {
  std::string name;
  double value;
};

/// Watches a run frame by frame and tells at the end.
class MetricRecorder {
 public:
  virtual ~MetricRecorder() = default;
  /// The first call sees the start.
  virtual void add(const FrameView& frame) = 0;
  /// Appends what the run has shown; nothing when it was too short to show anything.
  virtual void report(std::vector<ErrorMetric>& metrics) const = 0;
};

/// Every recorder that this scene has a use for. `start` is the state before the first frame.
std::vector<std::unique_ptr<MetricRecorder>> metricsFor(const FrameView& start);

}  // namespace ice_ice_baby
