// Density that the walls of a container add inside it.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "colliders/distance_table.h"
#include "colliders/shape_basis.h"
#include "fluid/rest_lattice.h"
#include "fluid/wall_sample.h"

namespace ice_ice_baby {

/// Where walls meet, the overlap of their half spaces counts once. Walls end at the rim of an open
/// container: they fade over a support radius on either side of it, as a half space would.
template <class Real>
class ContainerDensity {
 public:
  /// @param flat density of a flat wall over the distance to it; must outlive this object
  /// @param radius_m of a particle
  ContainerDensity(const RestLattice& lattice, const DistanceTable<Real>& flat, Real radius_m);

  /// @param point in the frame of the container
  /// @param rim of the container near the point
  /// @param near its walls near the point, or near rim->below
  WallSample<Real> at(const Vec3<Real>& point, const std::optional<Rim<Real>>& rim,
                      const NearSurfaces<Real>& near) const;

  /// Part of a wall that lies below the rim, seen from a point at its height, and its slope along
  /// z.
  std::pair<Real, Real> shareBelow(const Rim<Real>& rim) const;

  std::size_t bytes() const;

 private:
  /// What two walls at right angles share, over the distances to both, bilinear.
  struct EdgeTable {
    std::vector<Real> values;
    Real per_m = 0;
    struct Sample {
      Real value, slope_a, slope_b;
    };
    Sample at(Real a, Real b) const;
  };

  static EdgeTable edge(const RestLattice& lattice);
  static std::vector<Real> corner(const RestLattice& lattice);
  WallSample<Real> sumOf(const NearSurfaces<Real>& near) const;
  WallSample<Real> nearRim(const Rim<Real>& rim, const Vec3<Real>& local,
                           NearSurfaces<Real> near) const;
  void fadeOverWall(const Rim<Real>& rim, WallSample<Real>& sample) const;
  void addCorner(const std::array<NearSurface<Real>, 3>& walls, WallSample<Real>& sample) const;

  const DistanceTable<Real>& flat_;
  double support_m_;
  Real radius_;
  EdgeTable edge_;
  std::vector<Real> corner_;  ///< what three walls share, over the distances to all
};

}  // namespace ice_ice_baby
