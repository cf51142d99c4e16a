// The frames of a run of run_scene, and what is written while they pass.
#pragma once

#include <string>

#include "run_report.h"

namespace ice_ice_baby {

/// Files to write during a run; "": none.
struct RunOutputs {
  std::string frames;  ///< folder of pictures
  double frames_hz = 30.0;
  double sample_hz = 0.0;   ///< of series, record and metrics of the error; 0: every frame
  std::string series;       ///< CSV over time
  std::string record;       ///< .npy of every position
  std::string save;         ///< checkpoint
  double autosave_s = 0.0;  ///< simulated time from one checkpoint to the next; 0: none on the way
};

/// Runs the frames until simulated time `end_s`, until a value was not finite, or, where the run is
/// saved, until somebody interrupts it. Faces of the error are those of whole runs: one that goes
/// on from a checkpoint has none.
/// @param threads with which the error is measured, 0: all of the machine's
/// @throws InvalidInput when an output cannot be written; a checkpoint on the way is only warned of
RunRecord runFrames(Simulation& simulation, const RunOutputs& outputs, double end_s, int threads);

}  // namespace ice_ice_baby
