#include "spawn/spawn_particles.h"

#include "spawn/spawn_points.h"

namespace ice_ice_baby {

template <class Real>
Particles<Real> spawnParticles(const Scene& scene, std::vector<Spawn>& spawns) {
  Particles<Real> particles;
  const auto count = static_cast<std::size_t>(particleCount(scene));
  particles.position.resize(count);
  particles.predicted.resize(count);
  particles.velocity.resize(count);
  particles.id.resize(count);

  const SpawnPoints points(scene);
  std::uint32_t i = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const std::uint32_t first = i;
    points.forEach(k, [&](const Vec3d& point) {
      particles.position.set(i, point.cast<Real>());
      particles.predicted.set(i, point.cast<Real>());
      particles.velocity.set(i, scene.blocks[k].velocityAt(point).template cast<Real>());
      particles.id[i] = i;
      ++i;
    });
    spawns.push_back({first, i - first});
  }
  particles.next_id = i;
  return particles;
}

template Particles<float> spawnParticles(const Scene&, std::vector<Spawn>&);
template Particles<double> spawnParticles(const Scene&, std::vector<Spawn>&);

}  // namespace ice_ice_baby
