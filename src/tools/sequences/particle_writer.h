// Writes the particles over a run, for ParaView, Blender and others.
#pragma once

#include "ice_ice_baby/simulation.h"
#include "sequences/file_sequence.h"

namespace ice_ice_baby {

class ParticleWriter {
 public:
  /// Files particles_00000.vtk and so on, with velocity, temperature, ice, density, pressure, phase
  /// and id of each particle.
  /// @param format vtk (legacy, binary) or ply (binary)
  /// @throws InvalidInput for another format, or if the folder cannot be made
  ParticleWriter(const std::string& folder, const std::string& format);

  /// The particles now. @throws InvalidInput if a file cannot be written
  void write(const Simulation& simulation);
  /// After the last. @throws InvalidInput if the index cannot be written
  void finish() const { files_.writeIndex(); }

 private:
  bool ply_;
  FileSequence files_;
  std::vector<ParticleSample> particles_;
};

}  // namespace ice_ice_baby
