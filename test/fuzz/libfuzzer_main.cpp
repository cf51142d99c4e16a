// What libFuzzer calls; IIB_FUZZ_TARGET is the target that this program feeds.
#include <cstddef>
#include <cstdint>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ice_ice_baby::fuzz::IIB_FUZZ_TARGET(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
