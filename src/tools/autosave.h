// Checkpoints on the way, so that a long run that is killed need not begin again.
#pragma once

#include <string>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class Autosave {
 public:
  /// @param every_s simulated time from one checkpoint to the next; 0: none
  /// @param start_s simulated time now
  Autosave(std::string path, double every_s, double start_s)
      : path_(std::move(path)), every_s_(every_s), next_s_(start_s + every_s) {}

  /// Saves when it is time. What cannot be saved is only warned of: the older checkpoint is whole,
  /// and there may be room the next time.
  void look(const Simulation& simulation);

 private:
  std::string path_;
  double every_s_;
  double next_s_;
};

}  // namespace ice_ice_baby
