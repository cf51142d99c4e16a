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
  const auto add = [&](const Vec3d& point, const Vec3d& velocity_m_s) {
    particles.position.set(i, point.cast<Real>());
    particles.predicted.set(i, point.cast<Real>());
    particles.velocity.set(i, velocity_m_s.cast<Real>());
    particles.id[i] = i;
    ++i;
  };
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const std::uint32_t first = i;
    points.forEach(k, [&](const Vec3d& point) { add(point, scene.blocks[k].velocityAt(point)); });
    spawns.push_back({first, i - first});
  }
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    const std::uint32_t first = i;
    // Their body gives them their velocities.
    points.forEachOfSolid(k, [&](const Vec3d& point) { add(point, Vec3d::Zero()); });
    spawns.push_back({first, i - first});
  }
  particles.next_id = i;
  return particles;
}

template Particles<float> spawnParticles(const Scene&, std::vector<Spawn>&);
template Particles<double> spawnParticles(const Scene&, std::vector<Spawn>&);

}  // namespace ice_ice_baby
