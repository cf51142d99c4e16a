// The disc of a source as points from which particles start.
#pragma once

#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Maximum number of particles in a layer.
constexpr double kMaxSites = 1e5;

/// Particles in a layer of the source: the number of spacings squared that its disc holds, rounded,
/// and at least 1. A double, because a scene file can ask for more than an integer holds.
double siteCount(const Source& source, double spacing_m);

/// One layer of a source. Layers follow each other at the distance at which the jet has 98 % of the
/// density of water at rest.
struct Outlet {
  Outlet(const Source& source, double spacing_m);

  std::vector<Vec3d> sites;  ///< in the disc, m, relative to Source::pose()
  double layer_m3;           ///< water in a layer: a cube of the spacing for each site
};

}  // namespace ice_ice_baby
