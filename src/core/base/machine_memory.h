// How much memory this machine has.
#pragma once

namespace ice_ice_baby {

/// Physical memory in bytes.
double machineMemory_bytes();

}  // namespace ice_ice_baby
