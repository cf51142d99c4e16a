// Writes PNG pictures of a simulation without a display: shaded spheres as in rviz; in thermal
// scenes, ice and steam seen through clear water.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pictures/heat_painter.h"
#include "sequences/file_sequence.h"

namespace ice_ice_baby {

class FrameWriter {
 public:
  /// @param folder created if missing. Frames are named frame_00000.png and so on; frames of an
  /// earlier run are removed
  /// @throws InvalidInput if the folder cannot be created
  FrameWriter(const std::string& folder, const Scene& scene);

  /// Draws the next picture. @throws InvalidInput when the file cannot be written
  void write(const Simulation& simulation);

 private:
  void lookFromAbove(const Scene& scene);
  void paintPlainly(const Simulation& simulation);

  FileSequence files_;
  int shrink_;  ///< canvas pixels per picture pixel along an axis
  Canvas canvas_;
  std::optional<HeatPainter> heat_;  ///< only of a scene with heat
  std::vector<ParticleSample> particles_;
  std::vector<SpringSample> springs_;
};

}  // namespace ice_ice_baby
