// Writes the surfaces of water, ice and clouds of steam over a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluid_surface.h"
#include "ice_ice_baby/simulation.h"
#include "sequences/file_sequence.h"

namespace ice_ice_baby {

class SurfaceWriter {
 public:
  /// Files water_00000.ply, ice_00000.ply and steam_00000.ply from when there is any,
  /// solids_00000.obj in scenes with floating solids, and colliders.obj once. With heat the
  /// vertices of PLY files have the colours of the particles.
  /// @param format ply or obj
  /// @throws InvalidInput for another format, if the folder cannot be made, or without
  /// libopenvdb-dev
  SurfaceWriter(const std::string& folder, const std::string& format, const Scene& scene);

  /// The surfaces now. @throws InvalidInput if a file cannot be written
  void write(const Simulation& simulation);
  /// After the last. @throws InvalidInput if an index cannot be written
  void finish() const;

 private:
  struct Kept {
    Phase phase;
    FileSequence files;
  };
  FluidSurface surfaceOf(Phase phase, const Scene& scene) const;

  std::string folder_;
  bool obj_;
  std::vector<Kept> kept_;
  std::optional<FileSequence> solids_;
  std::vector<ParticleSample> particles_;
};

}  // namespace ice_ice_baby
