#include "spawn/spawn_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/item_names.h"
#include "base/point_grid.h"
#include "flow/outlet.h"
#include "ice_ice_baby/errors.h"
#include "spawn/spawn_points.h"

namespace ice_ice_baby {

namespace {

/// Overlapping lattices have particles closer than this, in spacings: the centre of a cube is 0.87
/// from its corners. Adjacent blocks keep a whole spacing.
constexpr double kOverlap_d = 0.9;

using Box = Eigen::AlignedBox3d;

/// Colliders are grown by this, in spacings, against particles of floating solids: less than half a
/// spacing, so that a solid may stand on a floor, and so much that none passes through a wall.
constexpr double kGrown_d = 0.45;

std::string keyOf(std::size_t block) { return "blocks." + std::to_string(block); }

/// "12 of its 64 particles lie"
std::string shareText(std::size_t some, std::size_t all) {
  return std::to_string(some) + " of its " + std::to_string(all) +
         (some == 1 ? " particles lies" : " particles lie");
}

/// Colliders with their names and keys.
class NamedSolids {
 public:
  /// @param radius_m of the particles; 0: only their centres count
  NamedSolids(const Scene& scene, double radius_m) : solids_(scene, radius_m) {
    forEachColliderList(scene, [&](const auto& list, const ColliderKind& kind) {
      for (std::size_t k = 0; k < list.size(); ++k) {
        keys_.push_back(std::string(kind.key) + "." + std::to_string(k));
        words_.push_back(std::string(kind.noun) + " " + list[k].name + " (" + keys_.back() + ")");
      }
    });
  }

  std::size_t count() const { return solids_.count(); }

  void requireFree(const std::string& key, const Block& block, double spacing_m,
                   std::size_t k) const {
    if (!solids_.near(k, boxAround(block))) return;
    std::size_t all = 0, within = 0, inside = 0;
    forEachLatticePoint(block, spacing_m, [&](const Vec3d& x) {
      ++all;
      within += solids_.reached(k, x);
      inside += solids_.holds(k, x);
    });
    const std::string cure = "; change " + key + ".min_m or max_m, or " + keys_[k] +
                             ".position_m, or set " + key + ".carve to true";
    if (within > 0) refuse(key, within, all, k, cure);
    if (solids_.closed(k) && inside > 0 && inside < all) {
      throw InvalidInput(key + ": " + shareText(all - inside, all) + " outside the closed " +
                         words_[k] + " and the others inside it" + cure);
    }
  }

  void requireFree(const std::string& key, const Source& source, double spacing_m,
                   std::size_t k) const {
    const std::vector<Vec3d> sites = Outlet(source, spacing_m).sites;
    const Posed pose = source.pose();
    const auto within = std::count_if(sites.begin(), sites.end(), [&](const Vec3d& site) {
      return solids_.reached(k, pose.toWorld(site));
    });
    if (within == 0) return;
    refuse(key + " (" + shortened(source.name) + ")", std::size_t(within), sites.size(), k,
           "; change " + key + ".position_m or radius_m, or " + keys_[k] + ".position_m");
  }

  void requireFree(const Scene& scene, const SpawnPoints& points, std::size_t solid,
                   std::size_t k) const {
    std::size_t all = 0, within = 0, inside = 0;
    points.forEachOfSolid(solid, [&](const Vec3d& x) {
      ++all;
      within += solids_.reached(k, x);
      inside += solids_.holds(k, x);
    });
    const std::string words = wordsFor("solids", solid, scene.solids[solid]);
    const std::string cure = "; change position_m of the solid, or " + keys_[k] + ".position_m";
    if (within > 0) refuse(words, within, all, k, cure);
    if (solids_.closed(k) && inside > 0 && inside < all) {
      throw InvalidInput(words + ": " + shareText(all - inside, all) + " outside the closed " +
                         words_[k] + " and the others inside it" + cure);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, std::size_t within, std::size_t all,
                           std::size_t k, const std::string& cure) const {
    throw InvalidInput(what + ": " + shareText(within, all) + " inside " +
                       (solids_.hollow(k) ? "the wall of " : "") + words_[k] + cure);
  }

  Solids solids_;
  std::vector<std::string> words_;
  std::vector<std::string> keys_;
};

void requireRest(const std::string& key, const SpawnPoints& points, std::size_t block) {
  std::size_t rest = 0;
  points.forEach(block, [&](const Vec3d&) { ++rest; });
  if (rest > 0) return;
  throw InvalidInput(key + ": carve leaves no particle, because all of them lie in colliders or " +
                     "touch them; change " + key + ".min_m or max_m, or move the colliders");
}

/// For each block, the part of its bounds that overlaps those of other blocks; empty for most.
std::vector<Box> sharedBounds(const std::vector<Box>& bounds) {
  std::vector<std::size_t> by_x(bounds.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t(0));
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) {
    return bounds[a].min().x() < bounds[b].min().x();
  });
  std::vector<Box> shared(bounds.size());
  for (auto a = by_x.begin(); a != by_x.end(); ++a) {
    for (auto b = a + 1; b != by_x.end(); ++b) {
      if (bounds[*b].min().x() > bounds[*a].max().x()) break;
      if (!bounds[*a].intersects(bounds[*b])) continue;
      const Box common = bounds[*a].intersection(bounds[*b]);
      shared[*a].extend(common);
      shared[*b].extend(common);
    }
  }
  return shared;
}

/// What spawns particles: first the blocks, then the floating solids.
struct Fillings {
  const Scene& scene;
  const SpawnPoints& spawn;

  std::size_t count() const { return scene.blocks.size() + scene.solids.size(); }
  bool water(std::size_t k) const { return k < scene.blocks.size(); }
  std::size_t solid(std::size_t k) const { return k - scene.blocks.size(); }
  double spacing_m(std::size_t k) const {
    return water(k) ? scene.spacing_m(scene.blocks[k]) : scene.fluid.spacing_m;
  }
  std::string words(std::size_t k) const {
    return water(k) ? keyOf(k) : wordsFor("solids", solid(k), scene.solids[solid(k)]);
  }
  template <class Visit>
  void forEach(std::size_t k, const Visit& visit) const {
    if (water(k)) return spawn.forEach(k, visit);
    spawn.forEachOfSolid(solid(k), visit);
  }
  Box bounds(std::size_t k) const {
    if (water(k)) return boxAround(scene.blocks[k]);
    Box box;
    forEach(k, [&](const Vec3d& x) { box.extend(x); });
    return box;
  }
  std::string cure(std::size_t k, std::size_t other) const {
    if (water(k)) return "; change min_m or max_m of one of them";
    if (!water(other)) return "; change position_m of one of them";
    return "; change position_m of the solid, or set " + keyOf(other) + ".carve to true";
  }
};

/// Adds blocks and solids one by one, so that cells never contain more points than a single lattice
/// has.
void requireApart(const Fillings& fillings) {
  double widest_m = fillings.scene.fluid.spacing_m;
  for (std::size_t k = 0; k < fillings.count(); ++k) {
    widest_m = std::max(widest_m, fillings.spacing_m(k));
  }
  const double edge = kOverlap_d * widest_m;
  std::vector<Box> bounds;
  for (std::size_t k = 0; k < fillings.count(); ++k) {
    bounds.push_back(fillings.bounds(k));
    bounds.back().max().array() += edge / 2;
    bounds.back().min().array() -= edge / 2;
  }
  const std::vector<Box> shared = sharedBounds(bounds);
  PointGrid grid(edge);
  for (std::size_t k = 0; k < fillings.count(); ++k) {
    if (shared[k].isEmpty()) continue;
    const double spacing = fillings.spacing_m(k);
    std::size_t all = 0, near = 0, other = k;
    std::vector<Vec3d> points;
    fillings.forEach(k, [&](const Vec3d& x) {
      ++all;
      if (!shared[k].contains(x)) return;
      points.push_back(x);
      const std::size_t found = grid.blockNear(x, kOverlap_d * spacing, k);
      if (found == k) return;
      ++near;
      other = std::min(other, found);
    });
    if (near > 0) {
      throw InvalidInput(fillings.words(k) + " overlaps " + fillings.words(other) + ": " +
                         shareText(near, all) + " within its " +
                         (fillings.water(other) ? "water" : "material") + fillings.cure(k, other));
    }
    for (const Vec3d& x : points) grid.add(x, k);
  }
}

/// Refuses floating solids that reach into a collider, and those that a wall passes through.
void requireFreeSolids(const Scene& scene, const SpawnPoints& points) {
  if (scene.solids.empty()) return;
  const NamedSolids colliders(scene, kGrown_d * scene.fluid.spacing_m);
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    for (std::size_t k = 0; k < colliders.count(); ++k) colliders.requireFree(scene, points, s, k);
  }
}

}  // namespace

void requireFreeSpawn(const Scene& scene) {
  const NamedSolids solids(scene, 0.0);
  const SpawnPoints points(scene);
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    const Block& block = scene.blocks[b];
    if (block.carve) {
      requireRest(keyOf(b), points, b);
      continue;
    }
    for (std::size_t k = 0; k < solids.count(); ++k) {
      solids.requireFree(keyOf(b), block, scene.spacing_m(block), k);
    }
  }
  requireFreeSolids(scene, points);
  requireApart({scene, points});
  for (std::size_t s = 0; s < scene.sources.size(); ++s) {
    if (!scene.sources[s].follow_frame.empty()) continue;  // it has no place yet
    for (std::size_t k = 0; k < solids.count(); ++k) {
      solids.requireFree("sources." + std::to_string(s), scene.sources[s], scene.fluid.spacing_m,
                         k);
    }
  }
}

}  // namespace ice_ice_baby
