// Where the particles of a scene begin.
#pragma once

#include <optional>
#include <vector>

#include "scene/lattice.h"
#include "spawn/solids.h"

namespace ice_ice_baby {

/// The lattice of each block, for blocks with `carve` without the points in solids. A particle that
/// remains touches no solid: its centre keeps half of fluid.spacing_m from each of them.
class SpawnPoints {
 public:
  /// @param scene must outlive it
  explicit SpawnPoints(const Scene& scene);

  /// Calls visit(point) for every particle that a block spawns, x fastest, then y, then z.
  template <class Visit>
  void forEach(std::size_t block, const Visit& visit) const {
    const Block& lattice = scene_.blocks[block];
    const std::vector<std::size_t> near = solidsAt(lattice);
    forEachLatticePoint(lattice, scene_.spacing_m(lattice), [&](const Vec3d& x) {
      if (near.empty() || isFree(x, near)) visit(x);
    });
  }

 private:
  std::vector<std::size_t> solidsAt(const Block& block) const;
  bool isFree(const Vec3d& x, const std::vector<std::size_t>& near) const;

  const Scene& scene_;
  std::optional<Solids> solids_;  ///< only if a block carves
};

}  // namespace ice_ice_baby
