// Periodic checkpoints, so that a long run that is killed can be continued.
#pragma once

#include <string>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class Autosave {
 public:
  /// @param every_s simulated time between two checkpoints; 0: none
  /// @param start_s present simulated time
  Autosave(std::string path, double every_s, double start_s)
      : path_(std::move(path)), every_s_(every_s), next_s_(start_s + every_s) {}

  /// Saves when a checkpoint is due. A failure is only a warning: the previous checkpoint is
  /// intact, and there may be disk space next time.
  void look(const Simulation& simulation);

 private:
  std::string path_;
  double every_s_;
  double next_s_;
};

}  // namespace ice_ice_baby
