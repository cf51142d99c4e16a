// Density that two flat walls at any angle share.
#pragma once

#include "base/spline_grid.h"
#include "fluid/wall_kernel.h"

namespace ice_ice_baby {

/// Integral of W* over what lies behind both of two half spaces. Adding both half spaces counts it
/// twice.
template <class Real>
class OverlapDensity {
 public:
  struct Sample {
    Real value, slope_a, slope_b;  ///< dimensionless, 1/m
    Real slope_cosine;
  };

  explicit OverlapDensity(const WallKernel& kernel);

  /// @param a, b distances to both surfaces, m, >= 0
  /// @param cosine of the angle between their normals
  Sample at(Real a, Real b, Real cosine) const;

  std::size_t bytes() const { return shared_.bytes(); }

 private:
  SplineGrid<Real> shared_;
};

}  // namespace ice_ice_baby
