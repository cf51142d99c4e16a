// Simulations of scenes that makeSimulation would refuse.
#pragma once

#include <memory>

#include "simulation/simulator.h"

namespace ice_ice_baby::test {

inline std::unique_ptr<Simulation> unchecked(const Scene& scene, int threads = 0) {
  return std::make_unique<Simulator<float>>(scene, threads);
}

}  // namespace ice_ice_baby::test
