// Read-only view of a simulated frame; frame 0 is the initial state.
#pragma once

#include <vector>

#include "metrics/density_meter.h"

namespace ice_ice_baby {

struct FrameView {
  const Simulation& simulation;
  const std::vector<ParticleSample>& particles;  ///< all particles, by id
  DensityError error;
  double frame_wall_s;                     ///< mean over the frames since the previous view
  std::vector<ColliderWrench> wrenches{};  ///< means over those frames; empty if not measured

  const StepReport& report() const { return simulation.report(); }
  const Scene& scene() const { return simulation.scene(); }
};

}  // namespace ice_ice_baby
