// What is known of a frame that has just been simulated; frame 0 is the start.
#pragma once

#include <vector>

#include "metrics/density_meter.h"

namespace ice_ice_baby {

struct FrameView {
  const Simulation& simulation;
  const std::vector<ParticleSample>& particles;  ///< all of them, by id
  DensityError error;
  double frame_wall_s;  ///< mean over the frames since the view before

  const StepReport& report() const { return simulation.report(); }
  const Scene& scene() const { return simulation.scene(); }
};

}  // namespace ice_ice_baby
