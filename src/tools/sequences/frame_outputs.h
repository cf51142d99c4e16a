// What a run writes frame by frame into folders: pictures, surfaces, particles.
#pragma once

#include <optional>
#include <vector>

#include "pictures/frame_writer.h"
#include "sequences/particle_writer.h"
#include "sequences/sequence_folders.h"
#include "sequences/surface_writer.h"

namespace ice_ice_baby {

class FrameOutputs {
 public:
  /// @throws InvalidInput as FrameWriter, SurfaceWriter and ParticleWriter
  FrameOutputs(const SequenceFolders& folders, const Scene& scene);

  /// The scene now. @throws InvalidInput if a file cannot be written
  void write(const Simulation& simulation);
  /// After the last. @throws InvalidInput if an index cannot be written
  std::vector<WrittenSequence> finish() const;

 private:
  template <class Writer>
  struct Sequence {
    Writer writer;
    WrittenSequence written;
  };

  std::optional<Sequence<FrameWriter>> pictures_;
  std::optional<Sequence<SurfaceWriter>> surfaces_;
  std::optional<Sequence<ParticleWriter>> particles_;
};

}  // namespace ice_ice_baby
