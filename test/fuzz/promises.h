// Promises that every target checks.
#pragma once

#include <string>

#include "ice_ice_baby/simulation.h"
#include "targets.h"

namespace ice_ice_baby::fuzz {

/// A refusal must be one printable line of readable length.
void requireReadable(const std::string& message);

/// Particles in the scene and those that left it, without those that sources added.
std::size_t particlesEver(const Simulation& simulation);

/// Every particle must be there, or counted as spilled or drained, and finite.
/// @param particles particlesEver at the start
void requireWhole(const Simulation& simulation, std::size_t particles);

/// Whether two frames of the scene take milliseconds.
bool isSmall(const Scene& scene, std::int64_t particles);

/// Runs two frames under requireWhole.
void runTwoFrames(Simulation& simulation);

/// Calls runTwoFrames unless the scene is large.
void runIfSmall(Scene scene);

}  // namespace ice_ice_baby::fuzz
