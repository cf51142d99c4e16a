#include "thermal/conduction_lattice.h"

#include <cmath>

namespace ice_ice_baby {

ConductionLattice::ConductionLattice(const Scene& scene)
    : spacing_m(scene.fluid.spacing_m),
      support_m(scene.supportRadius_m()),
      volume_m3(particleVolume_m3(scene.fluid, support_m)),
      mass_kg(particleMass_kg(scene.fluid, support_m)),
      moment_1_m3(0.0),
      links_m(0.0),
      area_m2(volume_m3 / spacing_m),
      kernel_(support_m) {
  const int reach = static_cast<int>(support_m / spacing_m) + 1;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const double r = spacing_m * std::sqrt(double(x * x + y * y + z * z));
        const double along = spacing_m * x;
        if (x != 0) moment_1_m3 -= kernel_.slope(r) / r * along * along;
        if (r > 0.0) links_m -= 2 * volume_m3 * kernel_.slope(r) / r;
      }
    }
  }
  links_m /= moment_1_m3;
}

double ConductionLattice::length_m(double distance_m) const {
  return -2 * volume_m3 / moment_1_m3 * kernel_.slope(distance_m) / distance_m;
}

double ConductionLattice::wallShare(double distance_m) const {
  const int reach = static_cast<int>(support_m / spacing_m) + 1;
  double sum = 0.0;
  for (int x = 0; x <= reach; ++x) {
    const double depth = distance_m + (x + 0.5) * spacing_m;
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const double aside = spacing_m * std::sqrt(double(y * y + z * z));
        sum += length_m(std::hypot(depth, aside)) * depth;
      }
    }
  }
  return sum / area_m2;
}

}  // namespace ice_ice_baby
