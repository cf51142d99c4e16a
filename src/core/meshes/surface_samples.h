// Points spread over a surface, each for a small part of it.
#pragma once

#include <vector>

#include "meshes/surface.h"

namespace ice_ice_baby {

/// What a point of a surface stands for.
struct SurfaceSample {
  Vec3d point;
  Vec3d normal;  ///< outwards; of an open surface, of either side
  double area_m2;
  /// How far the wall hides what lies behind it: 1 in the middle of a thin wall, 0 at its rim and
  /// on a thick solid.
  double opacity;
  /// Of an open surface: whether another one lies close by, in the direction of the normal, against
  /// it.
  bool covered_ahead, covered_behind;
};

/// The same surface twice.
struct SurfaceSamples {
  std::vector<SurfaceSample> coarse;  ///< each for a piece of at most half a spacing
  std::vector<SurfaceSample> fine;    ///< each for a piece of at most a quarter
};

/// @param spacing_m particle spacing; thinner walls are thin
SurfaceSamples samplesOf(const Surface& surface, double spacing_m);

}  // namespace ice_ice_baby
