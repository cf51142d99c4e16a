// Motions of a vessel for trials of leaks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby::leaks {

class VesselMotion {
 public:
  virtual ~VesselMotion() = default;
  /// Displacement and rotation about the centre of the vessel at a time, which may not decrease.
  virtual Posed at(double time_s) = 0;
};

/// Gentle ones first.
std::vector<std::string> motionNames();

/// @throws InvalidInput for an unknown name
std::unique_ptr<VesselMotion> makeMotion(const std::string& name, unsigned seed);

}  // namespace ice_ice_baby::leaks
