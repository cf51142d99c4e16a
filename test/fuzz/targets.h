// Functions that the fuzzers call with arbitrary bytes. In the ordinary build fuzz_seeds_test calls
// each with every committed seed.
#pragma once

#include <stdexcept>
#include <string>

namespace ice_ice_baby::fuzz {

/// Thrown if the code under test breaks a promise. Nothing catches it, so the fuzzer stops.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Accepts any bytes and may throw only Broken; any other exception is a finding.
using Target = void (*)(const std::string& bytes);

void sceneYaml(const std::string& bytes);   ///< a scene file
void overrides(const std::string& bytes);   ///< run_scene --set, one a line
void commands(const std::string& bytes);    ///< what users change between frames, one a line
void checkpoint(const std::string& bytes);  ///< a checkpoint, and edits of one whose checksum holds
#ifdef IIB_FUZZ_ROS
void parameterTree(const std::string& bytes);  ///< private parameters of the node, as XML-RPC
void requests(const std::string& bytes);       ///< a service request as it comes over the wire
#endif

}  // namespace ice_ice_baby::fuzz
