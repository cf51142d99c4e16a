// Scenes of any number of particles for the benchmarks.
#pragma once

#include <cstddef>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby::bench {

/// A closed tank, two thirds full of water at rest.
Scene stillPool(std::size_t count);

/// The scene dam_break at the spacing that gives about `count` particles.
Scene damBreak(std::size_t count);

/// Still water floating without gravity or walls: only the passes over pairs.
Scene floatingWater(std::size_t count);

}  // namespace ice_ice_baby::bench
