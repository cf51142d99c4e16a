// Checkpoints: a whole simulation as bytes and as a file, from which it goes on with the same bits.
// doc/checkpoints.md has the format.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// The scene as it is in force and all state of the simulation, checksummed. Fast: one pass over
/// memory, so that one thread may encode between two frames and another one write.
std::string encodeCheckpoint(const Simulation& simulation);

/// The simulation that was encoded; its next frames have the bits that those of the original have,
/// for any number of threads. Safe on bytes from anywhere.
/// @param origin names the bytes in messages, as the path of a file does
/// @param threads as for makeSimulation
/// @throws InvalidInput when the bytes are no checkpoint, of another version, truncated, changed,
/// or make no sense together
std::unique_ptr<Simulation> decodeCheckpoint(std::string_view bytes, const std::string& origin,
                                             int threads = 0);

/// Puts the bytes of a checkpoint at `path`, whole or not at all: whatever happens meanwhile, power
/// loss included, `path` holds either what it held or all of the bytes.
/// @throws InvalidInput that names the path and the cause (no space, no permission, ...); the old
/// file stays and nothing else is left behind
void writeCheckpoint(std::string_view bytes, const std::string& path);

/// Whether a checkpoint can be saved there as far as one can know beforehand.
/// @throws InvalidInput as writeCheckpoint would
void requireSavable(const std::string& path);

/// writeCheckpoint of encodeCheckpoint. @throws InvalidInput as writeCheckpoint
void saveCheckpoint(const Simulation& simulation, const std::string& path);

/// decodeCheckpoint of a file. @throws InvalidInput as decodeCheckpoint, and when the file cannot
/// be read; the message names the path
std::unique_ptr<Simulation> loadCheckpoint(const std::string& path, int threads = 0);

}  // namespace ice_ice_baby
