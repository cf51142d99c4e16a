// What the fuzzers feed with hostile bytes. Each target is also run by fuzz_seeds_test, over every
// committed seed, in the ordinary build.
#pragma once

#include <stdexcept>
#include <string>

namespace ice_ice_baby::fuzz {

/// A promise of the code under test does not hold. Nothing catches it: the fuzzer stops there.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A function that takes any bytes and throws only Broken; whatever else leaves it is a finding.
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
