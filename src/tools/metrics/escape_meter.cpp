#include "metrics/escape_meter.h"

#include <algorithm>

#include "scene/lattice.h"

namespace ice_ice_baby {

namespace {

/// Up to the middle of the walls: rounding may put a particle a hair into one.
bool inside(const Container& container, const Vec3d& local) {
  const double wall_m = container.wall_m / 2;
  const Vec3d half = container.size_m / 2 + Vec3d::Constant(wall_m);
  const Vec3d centre(0, 0, container.size_m.z() / 2);
  return ((local - centre).array().abs() < half.array()).all();
}

}  // namespace

EscapeMeter::EscapeMeter(const Scene& scene) {
  std::uint32_t first = 0;
  for (const Block& block : scene.blocks) {
    const double count = particleCount(block, scene.spacing_m(block), scene.limits.max_particles);
    const std::uint32_t last = first + static_cast<std::uint32_t>(count);
    for (const Container& container : scene.containers) {
      const Vec3d local = container.pose().toLocal(block.centre_m());
      if (!container.open_top && inside(container, local))
        held_.push_back({first, last, container});
    }
    first = last;
  }
}

std::size_t EscapeMeter::count(const Simulation& simulation,
                               const std::vector<ParticleSample>& particles) const {
  std::size_t escaped = 0;
  for (const Held& held : held_) {
    const Posed pose = simulation.colliderPose(held.container.name);
    escaped += static_cast<std::size_t>(
        std::count_if(particles.begin(), particles.end(), [&](const ParticleSample& p) {
          if (p.id < held.first_id || p.id >= held.last_id) return false;
          return !inside(held.container, pose.toLocal(Vec3d(p.x, p.y, p.z)));
        }));
  }
  return escaped;
}

std::size_t countEscaped(const Simulation& simulation) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  return EscapeMeter(simulation.scene()).count(simulation, particles);
}

}  // namespace ice_ice_baby
