#include "autosave.h"

#include <cstdio>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

void Autosave::look(const Simulation& simulation) {
  const double time_s = simulation.report().time_s;
  if (every_s_ <= 0.0 || time_s < next_s_ - 1e-9) return;
  next_s_ = time_s + every_s_;
  try {
    saveCheckpoint(simulation, path_);
  } catch (const InvalidInput& e) {
    std::fprintf(stderr, "run_scene: warning: %s\n", e.what());
  }
}

}  // namespace ice_ice_baby
