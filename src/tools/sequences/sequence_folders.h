// Folders into which a run writes something frame by frame, and what it wrote.
#pragma once

#include <cstddef>
#include <string>

namespace ice_ice_baby {

/// "" writes none.
struct SequenceFolders {
  std::string frames;
  std::string surface, surface_format = "ply";
  std::string particles, particles_format = "vtk";

  bool any() const { return !frames.empty() || !surface.empty() || !particles.empty(); }
};

/// What was written, and what writing it took.
struct WrittenSequence {
  std::string what, folder;
  std::size_t frames = 0;
  double wall_s = 0.0;
};

}  // namespace ice_ice_baby
