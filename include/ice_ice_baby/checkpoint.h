// Checkpoints: the whole state of a simulation as bytes or as a file. A restored simulation
// continues bit for bit. doc/checkpoints.md describes the format.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Encodes the scene in force and all state of the simulation, with a checksum. Takes one pass over
/// memory, so one thread can encode between two frames while another one writes.
std::string encodeCheckpoint(const Simulation& simulation);

/// Restores the simulation that was encoded. Its next frames are bit-identical to those of the
/// original, for any number of threads. Safe on untrusted bytes.
/// @param origin name of the bytes in messages, such as a path
/// @param threads as for makeSimulation
/// @throws InvalidInput if the bytes are not a checkpoint, or are of another version, truncated,
/// corrupted or inconsistent
std::unique_ptr<Simulation> decodeCheckpoint(std::string_view bytes, const std::string& origin,
                                             int threads = 0);

/// Writes a checkpoint atomically: whatever happens meanwhile, power loss included, `path` holds
/// either its previous contents or the complete checkpoint.
/// @throws InvalidInput that names the path and the cause (no space, no permission, ...). The old
/// file is kept and no other file is left behind
void writeCheckpoint(std::string_view bytes, const std::string& path);

/// Checks in advance, as far as possible, that a checkpoint can be written to the path.
/// @throws InvalidInput as writeCheckpoint would
void requireSavable(const std::string& path);

/// Encodes and writes a checkpoint. @throws InvalidInput as writeCheckpoint
void saveCheckpoint(const Simulation& simulation, const std::string& path);

/// Reads and decodes a checkpoint file. @throws InvalidInput as decodeCheckpoint, and if the file
/// cannot be read; the message names the path
std::unique_ptr<Simulation> loadCheckpoint(const std::string& path, int threads = 0);

}  // namespace ice_ice_baby
