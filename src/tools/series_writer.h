// A run as a table over time: one CSV row per frame, of which the first is the start.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class SeriesWriter {
 public:
  /// Writes the line of column names. @throws InvalidInput when the file cannot be written
  explicit SeriesWriter(std::string path);

  /// Appends the state now. `error` is that of measureDensityError().
  /// @throws InvalidInput when the file cannot be written
  void write(const Simulation& simulation, const Simulation::DensityError& error);

 private:
  std::string path_;
  std::ofstream file_;
  std::vector<ParticleSample> particles_;
};

/// Writes the state now as CSV, one row per particle, by id. @throws InvalidInput when the file
/// cannot be written
void writeParticles(const std::string& path, const Simulation& simulation);

}  // namespace ice_ice_baby
