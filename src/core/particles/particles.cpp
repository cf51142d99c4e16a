#include "particles/particles.h"

#include "scene/lattice.h"

namespace ice_ice_baby {

template <class Real>
void Particles<Real>::reorder(const std::vector<Index>& order) {
  permute(position, order, scratch);
  permute(predicted, order, scratch);
  permute(velocity, order, scratch);
  permute(id, order, id_scratch);
}

template <class Real>
Particles<Real> spawnParticles(const Scene& scene, std::vector<Spawn>& spawns) {
  Particles<Real> particles;
  const auto count = static_cast<std::size_t>(particleCount(scene));
  particles.position.resize(count);
  particles.predicted.resize(count);
  particles.velocity.resize(count);
  particles.id.resize(count);

  std::uint32_t i = 0;
  for (const Block& block : scene.blocks) {
    const std::uint32_t first = i;
    forEachLatticePoint(block, scene.spacing_m(block), [&](const Vec3d& point) {
      particles.position.set(i, point.cast<Real>());
      particles.predicted.set(i, point.cast<Real>());
      particles.velocity.set(i, block.velocityAt(point).template cast<Real>());
      particles.id[i] = i;
      ++i;
    });
    spawns.push_back({first, i - first});
  }
  return particles;
}

template struct Particles<float>;
template struct Particles<double>;
template Particles<float> spawnParticles(const Scene&, std::vector<Spawn>&);
template Particles<double> spawnParticles(const Scene&, std::vector<Spawn>&);

}  // namespace ice_ice_baby
