// Compression, by the solver's own kernel and by the cubic spline that all solvers are compared by.
#pragma once

#include "error_faces.h"

namespace ice_ice_baby {

/// Means over the frames; the start, which no setting has touched, is left out.
class DensityWatch final : public ErrorWatch {
 public:
  void add(const FrameView& frame) override;
  void tell(std::vector<ErrorFace>& faces) const override;

 private:
  Simulation::DensityError cubic_, own_;  ///< sums
  std::size_t frames_ = 0;
};

}  // namespace ice_ice_baby
