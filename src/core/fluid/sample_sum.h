// What samples of a surface add to the density at a point.
#pragma once

#include <vector>

#include "fluid/wall_kernel.h"
#include "meshes/surface_samples.h"

namespace ice_ice_baby {

/// Samples as columns, with what each adds to points on either side of it.
class SampleColumns {
 public:
  /// Columns are padded to a multiple of this, with samples that add nothing.
  static constexpr std::size_t kLanes = 16;

  /// @param closed whether the samples are of a closed surface
  void add(const SurfaceSample& sample, bool closed);
  void pad();
  bool empty() const { return x.empty(); }

  std::vector<float> x, y, z;
  std::vector<float> nx, ny, nz;  ///< normals times areas
  std::vector<float> ahead,
      behind;  ///< factors for points on the side of the normal and against it
};

/// Input of the vectorised sum.
struct SampleInput {
  const SampleColumns& samples;
  const float* table;
  float size;    ///< of the table
  float per_m2;  ///< entries per square metre
};

/// The kernel over the squared distance: integral of W* r^2 from r on, over r^3.
class SampleKernel {
 public:
  explicit SampleKernel(const WallKernel& kernel);

  /// Sum over the samples.
  /// @param inside whether x lies in the solid that the samples enclose
  double sum(const Vec3d& x, bool inside, const SampleColumns& samples) const;

 private:
  float per_m2_;              ///< entries of the table per square metre
  std::vector<float> table_;  ///< ends in 0
};

}  // namespace ice_ice_baby
