// Colliders and the density that they add, for its tests.
#pragma once

#include "fixtures.h"
#include "fluid/boundary_density.h"
#include "particles/kernels.h"

namespace ice_ice_baby::test {

constexpr double kWallSpacing_m = 0.05, kWallSupport_m = 0.1;

inline Scene sceneOfWalls() {
  Scene scene;
  scene.fluid.spacing_m = kWallSpacing_m;
  return scene;
}

struct Walls {
  explicit Walls(const Scene& s)
      : scene(s),
        colliders(scene, kWallSpacing_m / 2),
        density(scene, colliders,
                particleMass_kg(scene.fluid, kWallSupport_m) / scene.fluid.rest_density_kg_m3) {}
  double at(const Vec3d& point) const { return density.at(point).value; }

  Scene scene;
  Colliders<double> colliders;
  BoundaryDensity<double> density;
};

}  // namespace ice_ice_baby::test
