#include "core_water.h"

namespace ice_ice_baby::bench {

namespace {

Particles<float> particlesOf(const SettledWater& water) {
  Particles<float> particles;
  for (auto* field : {&particles.position, &particles.predicted, &particles.velocity}) {
    field->resize(water.size());
  }
  for (std::size_t i = 0; i < water.size(); ++i) {
    const Vec3<float> point = kSupport_m * Vec3<float>(water.x[i], water.y[i], water.z[i]);
    particles.position.set(i, point);
    particles.predicted.set(i, point);
    particles.id.push_back(static_cast<std::uint32_t>(i));
  }
  return particles;
}

}  // namespace

CoreWater::CoreWater(std::size_t count)
    : particles(particlesOf(SettledWater(count))), neighbours(kSupport_m, kSkin_m) {
  particles.reorder(neighbours.sortOrder(particles.predicted));
  neighbours.build(particles.predicted);
}

}  // namespace ice_ice_baby::bench
