// The key of a cell of a grid without bounds.
#pragma once

#include <cstdint>

namespace ice_ice_baby {

/// 21 bits per axis: cells 2^21 apart along an axis have the same key.
inline std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  return (std::uint64_t(x) & kMask) | (std::uint64_t(y) & kMask) << 21 |
         (std::uint64_t(z) & kMask) << 42;
}

}  // namespace ice_ice_baby
