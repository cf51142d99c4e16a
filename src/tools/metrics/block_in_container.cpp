#include "metrics/block_in_container.h"

#include "ice_ice_baby/each_collider.h"
#include "scene/lattice.h"

namespace ice_ice_baby {

namespace {

using LatticeSize = Eigen::Array<std::int64_t, 3, 1>;

bool boxOfWaterAtRest(const Block& block, const FrameView& start, const LatticeSize& lattice) {
  const bool whole = std::int64_t(start.particles.size()) == lattice.prod();
  return whole && !block.sheet && start.report().kinetic_energy_j == 0.0;
}

}  // namespace

std::optional<BlockInContainer> blockInContainer(const FrameView& start) {
  const Scene& scene = start.scene();
  std::size_t colliders = 0;
  forEachCollider(scene, [&](const Collider&) { ++colliders; });
  const bool alone = scene.blocks.size() == 1 && scene.containers.size() == 1 && colliders == 1;
  const Vec3d& g = scene.gravity_m_s2;
  const bool constant = scene.sources.empty() && scene.drains.empty();
  if (!alone || !constant || g.x() != 0.0 || g.y() != 0.0 || !(g.z() < 0.0)) return std::nullopt;
  const Block& block = scene.blocks.front();
  const Container& container = scene.containers.front();
  const bool upright = container.follow_frame.empty() && container.rpy_deg.isZero();
  const double spacing_m = scene.fluid.spacing_m;
  const LatticeSize lattice = latticeSize(block, spacing_m);
  if (!upright || !boxOfWaterAtRest(block, start, lattice)) return std::nullopt;

  BlockInContainer placed;
  const Vec3d half(container.size_m.x() / 2, container.size_m.y() / 2, 0.0);
  placed.floor_m = container.position_m - half;
  placed.container_size_m = container.size_m;
  placed.block_size_m = spacing_m * lattice.cast<double>().matrix();
  placed.min_gap_m = block.min_m - placed.floor_m;
  placed.max_gap_m = container.size_m - placed.min_gap_m - placed.block_size_m;
  const double little_m = spacing_m / 2;
  const bool inside =
      (placed.min_gap_m.array() > -little_m).all() && (placed.max_gap_m.array() > -little_m).all();
  return inside ? std::optional<BlockInContainer>(placed) : std::nullopt;
}

}  // namespace ice_ice_baby
