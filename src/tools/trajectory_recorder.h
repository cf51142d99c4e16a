// Records the position of every particle in every frame as one NumPy array.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "frame_view.h"

namespace ice_ice_baby {

/// A .npy file, format version 1.0: float32 of shape (frames, particles, 3), m, particles by id.
/// Frame 0 is the initial state. Particles that left the bounds of the scene are NaN.
class TrajectoryRecorder {
 public:
  /// @throws InvalidInput when the file cannot be written
  TrajectoryRecorder(std::string path, std::size_t particles);

  /// @throws InvalidInput when the file cannot be written
  void add(const FrameView& frame);

 private:
  void writeHeader();

  std::string path_;
  std::ofstream file_;
  std::size_t particles_;
  std::vector<std::uint32_t> ids_;  ///< (particles) of frame 0, ascending
  std::size_t frames_ = 0;
};

}  // namespace ice_ice_baby
