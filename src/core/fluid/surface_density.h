// Density that a surface of triangles adds to particles beside it.
#pragma once

#include <memory>
#include <vector>

#include "fluid/wall_kernel.h"
#include "fluid/wall_sample.h"
#include "meshes/block_index.h"
#include "meshes/surface.h"

namespace ice_ice_baby {

/// The integral of the wall kernel over the solid, tabulated around it as a quadratic B-spline. A
/// thin wall counts as if the solid went on behind it (SurfaceSample::opacity), so that each side
/// of it is a wall to its own water.
template <class Real>
class SurfaceDensity {
 public:
  /// Of a surface that is shared itself, the density of an earlier scene if it is kept.
  static std::shared_ptr<const SurfaceDensity> shared(const Surface& surface,
                                                      const WallKernel& kernel, double spacing_m);

  SurfaceDensity(const Surface& surface, const WallKernel& kernel, double spacing_m);

  /// @param point in the frame of the surface
  WallSample<Real> at(const Vec3<Real>& point) const;

  std::size_t bytes() const { return blocks_.bytes() + coefficients_.capacity() * sizeof(Real); }

 private:
  /// Nodes along the side of a block with those of its neighbours that its cells use.
  static constexpr int kSide = BlockIndex::kBlock + 2;
  static constexpr std::size_t kNodes = std::size_t(kSide) * kSide * kSide;

  /// For each node of the blocks the density, and the coefficient if it is close to the surface.
  struct Values {
    std::vector<double> of;
    std::vector<double> coefficient;
  };

  void interpolate(const Values& values);

  BlockIndex blocks_;
  std::vector<Real> coefficients_;
};

}  // namespace ice_ice_baby
