// How much memory this process has in use.
#pragma once

#include <cstddef>

namespace ice_ice_baby {

/// Bytes resident now; 0 where the system does not tell.
std::size_t residentBytes();

/// The most bytes that were resident at any time; 0 where the system does not tell.
std::size_t peakResidentBytes();

}  // namespace ice_ice_baby
