#include "loading/memory_need.h"

#include <cmath>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

void requireMemory(const Scene& scene, double memory_bytes) {
  const double particles = double(particleCount(scene));
  const double needed_bytes = particles * kMinParticle_bytes;
  if (needed_bytes <= memory_bytes) return;
  throw InvalidInput((scene.solids.empty() ? "the blocks hold " : "the blocks and solids hold ") +
                     numberText(particles) + " particles, which take at least " +
                     numberText(std::ceil(needed_bytes / 1e6)) + " MB; this machine has " +
                     numberText(std::floor(memory_bytes / 1e6)) +
                     " MB. Enlarge fluid.spacing_m or shrink them");
}

}  // namespace ice_ice_baby
