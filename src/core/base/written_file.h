// Writes a file at once.
#pragma once

#include <fstream>
#include <string>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

/// @throws InvalidInput if the file cannot be written
inline void writeFile(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), std::streamsize(bytes.size()));
  file.close();
  if (!file) throw InvalidInput("cannot write " + path + "; is the disk full?");
}

}  // namespace ice_ice_baby
