// Numbered files of a run in a folder, and the index that ParaView opens as a sequence in time.
#pragma once

#include <string>
#include <vector>

namespace ice_ice_baby {

class FileSequence {
 public:
  /// Files are named NAME_00000.EXTENSION and so on; those of an earlier run are removed.
  /// @param folder created if missing
  /// @throws InvalidInput if the folder cannot be created
  FileSequence(std::string folder, std::string name, std::string extension);

  /// Path of the next file, which shows the scene at a simulated time.
  std::string next(double time_s);

  /// Whether no file has been named yet.
  bool empty() const { return files_.empty(); }

  /// Writes NAME.EXTENSION.series, a JSON list of the files and their times.
  /// @throws InvalidInput if it cannot be written
  void writeIndex() const;

 private:
  bool has(const std::string& file) const;

  std::string folder_, name_, extension_;
  std::vector<std::pair<std::string, double>> files_;  ///< and their times
};

}  // namespace ice_ice_baby
