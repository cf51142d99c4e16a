// A run as a table over time: one CSV row per sample, of which the first is the start.
#pragma once

#include <fstream>
#include <string>

#include "frame_view.h"

namespace ice_ice_baby {

class SeriesWriter {
 public:
  /// @throws InvalidInput when the file cannot be written
  explicit SeriesWriter(std::string path);

  /// Writes a row, and before the first one the names of the columns. @throws InvalidInput when the
  /// file cannot be written
  void add(const FrameView& frame);

 private:
  std::string path_;
  std::ofstream file_;
  bool named_ = false;  ///< whether the columns have their names
};

/// Writes the state now as CSV, one row per particle, by id. @throws InvalidInput when the file
/// cannot be written
void writeParticles(const std::string& path, const Simulation& simulation);

}  // namespace ice_ice_baby
