// Where the particles of a scene begin.
#pragma once

#include <optional>
#include <vector>

#include "base/point_grid.h"
#include "scene/lattice.h"
#include "solids/solid_points.h"
#include "spawn/solids.h"

namespace ice_ice_baby {

/// The lattice of each block, for blocks with `carve` without the points in colliders and floating
/// solids. A particle that remains touches none of them: its centre keeps half of fluid.spacing_m
/// from each collider, and almost a spacing from each particle of a floating solid.
class SpawnPoints {
 public:
  /// @param scene must outlive it
  explicit SpawnPoints(const Scene& scene);

  /// Calls visit(point) for every particle that a block spawns, x fastest, then y, then z.
  template <class Visit>
  void forEach(std::size_t block, const Visit& visit) const {
    const Block& lattice = scene_.blocks[block];
    const std::vector<std::size_t> near = solidsAt(lattice);
    const bool carved = !near.empty() || (lattice.carve && floating_);
    forEachLatticePoint(lattice, scene_.spacing_m(lattice), [&](const Vec3d& x) {
      if (!carved || isFree(x, near)) visit(x);
    });
  }

  /// Calls visit(point) for every particle of a floating solid.
  template <class Visit>
  void forEachOfSolid(std::size_t solid, const Visit& visit) const {
    const Posed pose = scene_.solids[solid].pose();
    forEachSolidPoint(scene_.solids[solid], scene_.fluid.spacing_m,
                      [&](const Vec3d& x) { visit(Vec3d(pose.toWorld(x))); });
  }

 private:
  std::vector<std::size_t> solidsAt(const Block& block) const;
  bool isFree(const Vec3d& x, const std::vector<std::size_t>& near) const;

  const Scene& scene_;
  std::optional<Solids> solids_;       ///< only if a block carves
  std::optional<PointGrid> floating_;  ///< particles of floating solids; only if a block carves
};

}  // namespace ice_ice_baby
