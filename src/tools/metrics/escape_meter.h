// Water that got out of closed containers.
#pragma once

#include <cstdint>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class EscapeMeter {
 public:
  explicit EscapeMeter(const Scene& scene);

  /// Particles of blocks that began in a closed container and are no longer inside it.
  /// @param simulation of the scene
  /// @param particles of it, as Simulation::sample gives them now
  std::size_t count(const Simulation& simulation,
                    const std::vector<ParticleSample>& particles) const;

 private:
  /// Particles that one block spawned in one container.
  struct Held {
    std::uint32_t first_id, last_id;  ///< last_id is not among them
    Container container;
  };
  std::vector<Held> held_;
};

/// For whoever asks only once.
std::size_t countEscaped(const Simulation& simulation);

}  // namespace ice_ice_baby
