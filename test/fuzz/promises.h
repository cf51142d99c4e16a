// What every target holds the code to.
#pragma once

#include <string>

#include "ice_ice_baby/simulation.h"
#include "targets.h"

namespace ice_ice_baby::fuzz {

/// A refusal is one line that a terminal can show, of a length that a person reads.
void requireReadable(const std::string& message);

/// Every particle is there and finite.
void requireWhole(const Simulation& simulation, std::size_t particles);

/// Runs two frames of a scene that is small enough for a fuzzer, under requireWhole. A scene that
/// is valid but large is left alone.
void runIfSmall(const Scene& scene);

}  // namespace ice_ice_baby::fuzz
