// Density error with the same kernel for every solver, for comparisons.
#pragma once

#include <memory>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

struct DensityError {
  double mean = 0.0;  ///< of max(rho / rho_0 - 1, 0) over the particles
  double max = 0.0;
  double volume_lost = 0.0;  ///< mean of 1 - 1 / max(rho / rho_0, 1): volume lost to compression
};

/// Measures with the cubic spline with h = 2 d, independently of the kernel and radius of the
/// solver. Positions are floats, like samples, in both precisions.
class DensityMeter {
 public:
  /// @param threads threads to use, 0: all of the machine's
  explicit DensityMeter(const Scene& scene, int threads = 0);
  ~DensityMeter();

  /// @param simulation of the scene
  /// @param particles all of its particles, as Simulation::sample gives them now
  DensityError measure(const Simulation& simulation, const std::vector<ParticleSample>& particles);

 private:
  class Reference;
  std::unique_ptr<Reference> reference_;
  std::vector<float> volumes_;
};

/// Measures once.
DensityError measureDensityError(const Simulation& simulation);

}  // namespace ice_ice_baby
