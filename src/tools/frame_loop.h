// The frames of a run of run_scene, and what is written while they pass.
#pragma once

#include <string>

#include "run_report.h"

namespace ice_ice_baby {

/// Files to write during a run; "": none.
struct RunOutputs {
  std::string frames;  ///< folder of pictures
  double frames_hz = 30.0;
  double sample_hz = 0.0;  ///< of series, record and faces of the error; 0: every frame
  std::string series;      ///< CSV over time
  std::string record;      ///< .npy of every position
};

/// Runs the frames of `duration_s`, or until a value was not finite.
/// @throws InvalidInput when an output cannot be written
RunRecord runFrames(Simulation& simulation, const RunOutputs& outputs, double duration_s);

}  // namespace ice_ice_baby
