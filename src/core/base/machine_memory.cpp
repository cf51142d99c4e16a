#include "base/machine_memory.h"

#include <unistd.h>

namespace ice_ice_baby {

double machineMemory_bytes() {
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
}

}  // namespace ice_ice_baby
