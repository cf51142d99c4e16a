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

/// Whether two frames of a scene take no more than milliseconds.
bool isSmall(const Scene& scene);

/// Runs two frames under requireWhole.
void runTwoFrames(Simulation& simulation);

/// runTwoFrames of a scene; one that is valid but large is left alone.
void runIfSmall(Scene scene);

}  // namespace ice_ice_baby::fuzz
