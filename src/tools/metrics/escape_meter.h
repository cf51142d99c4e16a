// Counts water that has left closed colliders.
#pragma once

#include <memory>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class EscapeMeter {
 public:
  explicit EscapeMeter(const Scene& scene);
  ~EscapeMeter();

  /// Particles that began in a closed collider and are no longer inside it.
  /// @param simulation of the scene
  /// @param particles of it, as Simulation::sample gives them now
  std::size_t count(const Simulation& simulation,
                    const std::vector<ParticleSample>& particles) const;

 private:
  class Enclosed;
  std::unique_ptr<Enclosed> enclosed_;
};

/// Counts once.
std::size_t countEscaped(const Simulation& simulation);

}  // namespace ice_ice_baby
