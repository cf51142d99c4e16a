// Memory use of this process.
#pragma once

#include <cstddef>

namespace ice_ice_baby {

/// Bytes resident now; 0 if unknown.
std::size_t residentBytes();

/// Peak number of resident bytes; 0 if unknown.
std::size_t peakResidentBytes();

}  // namespace ice_ice_baby
