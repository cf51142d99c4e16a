#include "spawn/spawn_points.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Carved water keeps this distance from the particles of floating solids, in spacings: that of
/// water beside them, less rounding.
constexpr double kBeside_d = 0.99;

bool carves(const Scene& scene) {
  return std::any_of(scene.blocks.begin(), scene.blocks.end(),
                     [](const Block& block) { return block.carve; });
}

/// Particles of all blocks and floating solids if no block carves.
double wholeCount(const Scene& scene) {
  const double max_count = scene.limits.max_particles;
  double count = 0.0;
  for (const Block& block : scene.blocks) {
    count += latticeCount(block, scene.spacing_m(block), std::max(0.0, max_count - count));
  }
  for (const Solid& solid : scene.solids) {
    count += solidCount(solid, scene.fluid.spacing_m, std::max(0.0, max_count - count));
  }
  return count;
}

}  // namespace

SpawnPoints::SpawnPoints(const Scene& scene) : scene_(scene) {
  if (!carves(scene)) return;
  solids_.emplace(scene, scene.fluid.spacing_m / 2);
  if (scene.solids.empty()) return;
  floating_.emplace(scene.fluid.spacing_m);
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    forEachOfSolid(k, [&](const Vec3d& x) { floating_->add(x, k); });
  }
}

/// Solids that particles of the block may touch; none for a block that is not carved.
std::vector<std::size_t> SpawnPoints::solidsAt(const Block& block) const {
  std::vector<std::size_t> near;
  if (!block.carve) return near;
  const Eigen::AlignedBox3d box = boxAround(block);
  for (std::size_t k = 0; k < solids_->count(); ++k) {
    if (solids_->near(k, box)) near.push_back(k);
  }
  return near;
}

bool SpawnPoints::isFree(const Vec3d& x, const std::vector<std::size_t>& near) const {
  const std::size_t none = scene_.solids.size();
  const double beside_m = kBeside_d * scene_.fluid.spacing_m;
  if (floating_ && floating_->blockNear(x, beside_m, none) != none) return false;
  return std::none_of(near.begin(), near.end(),
                      [&](std::size_t k) { return solids_->reached(k, x); });
}

std::int64_t particleCount(const Scene& scene) {
  const double whole = wholeCount(scene);
  if (!carves(scene) || whole > 4 * scene.limits.max_particles) {
    return static_cast<std::int64_t>(std::min(whole, 9e18));
  }
  const SpawnPoints points(scene);
  std::int64_t count = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    points.forEach(k, [&](const Vec3d&) { ++count; });
  }
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    points.forEachOfSolid(k, [&](const Vec3d&) { ++count; });
  }
  return count;
}

}  // namespace ice_ice_baby
