// Byte order of this machine, which messages of raw bytes tell.
#pragma once

#include <cstdint>
#include <cstring>

namespace ice_ice_baby {

inline bool bigEndian() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

}  // namespace ice_ice_baby
