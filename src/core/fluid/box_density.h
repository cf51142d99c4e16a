// Density that a solid box adds.
#pragma once

#include "base/spline_grid.h"
#include "colliders/aligned_box.h"
#include "fluid/wall_kernel.h"
#include "fluid/wall_sample.h"

namespace ice_ice_baby {

/// Integral of W* over a box. It is a sum over the corners of an odd function of their coordinates:
/// the integral over the box between the point and the corner, tabulated.
template <class Real>
class BoxDensity {
 public:
  explicit BoxDensity(const WallKernel& kernel);

  /// @param box relative to the point, in its own frame
  WallSample<Real> at(const AlignedBox<Real>& box) const;

  std::size_t bytes() const { return to_corner_.bytes(); }

 private:
  Real reach_;
  SplineGrid<Real> to_corner_;
};

}  // namespace ice_ice_baby
