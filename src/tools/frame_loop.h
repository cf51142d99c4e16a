// The frame loop of run_scene and its output files.
#pragma once

#include <string>

#include "run_report.h"
#include "sequences/sequence_folders.h"

namespace ice_ice_baby {

/// Files to write during a run; "" writes none.
struct RunOutputs {
  SequenceFolders folders;
  double frames_hz = 30.0;  ///< of what goes into them
  double sample_hz = 0.0;   ///< rate of series, record and error metrics; 0: every frame
  std::string series;       ///< CSV over time
  std::string record;       ///< .npy of every position
  std::string save;         ///< checkpoint
  double autosave_s = 0.0;  ///< simulated time between checkpoints; 0: only at the end
  bool wrenches = false;    ///< for the report over the last half second, for the series all along
};

/// Runs frames until simulated time `end_s`, until a value is not finite, or, if the run is saved,
/// until it is interrupted. Error metrics apply to whole runs, so a run continued from a checkpoint
/// has none.
/// @param threads used to measure the error, 0: all of the machine's
/// @throws InvalidInput if an output cannot be written; a failed autosave is only a warning
RunRecord runFrames(Simulation& simulation, const RunOutputs& outputs, double end_s, int threads);

}  // namespace ice_ice_baby
