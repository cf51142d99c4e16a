// Density that colliders add to particles near them. Without it particles stack at walls.
//
// A flat surface counts as if the rest lattice continued behind it, with its first layer half a
// spacing deep, so a lattice at rest in a box has exactly the rest density everywhere. Where walls
// of a box meet, the overlap of their half spaces is counted once. Walls end at the rim of an open
// container: they fade over a support radius on either side of it, as a half space would. A curved
// surface counts by the part of the kernel volume that lies inside a sphere of its curvature.
#pragma once

#include <array>
#include <vector>

#include "colliders/clearance.h"
#include "colliders/colliders.h"
#include "colliders/distance_table.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

/// Density of colliders at a particle centre, relative to rest density, and its gradient.
template <class Real>
struct WallSample {
  Real value = 0;                            ///< dimensionless
  Vec3<Real> gradient = Vec3<Real>::Zero();  ///< 1/m
};

template <class Real>
class BoundaryDensity {
 public:
  /// @param volume_m3 m / rho_0, the volume of a particle
  BoundaryDensity(const Scene& scene, const Colliders<Real>& colliders, double volume_m3);

  WallSample<Real> at(const Vec3<Real>& point) const;

  /// Calls visit(i, sample) for every point of first ... last - 1 that may be near a collider.
  template <class Visit>
  void forEachNear(const VectorField<Real>& points, std::size_t first, std::size_t last,
                   const Visit& visit) const {
    const Real margin = static_cast<Real>(h_) - radius_;
    ice_ice_baby::forEachNear(colliders_, Paths<Real>{points, points}, margin, first, last,
                              [&](std::size_t i) { visit(i, at(points.at(i))); });
  }

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
  DistanceTable<Real> halfSpace() const;
  DistanceTable<Real> ball(Real radius) const;
  EdgeTable edge() const;
  std::vector<Real> corner() const;
  double ghosts(const std::array<double, 3>& distances, int walls) const;
  WallSample<Real> sumOf(const NearSurfaces<Real>& near, const DistanceTable<Real>& table) const;
  WallSample<Real> nearRim(const Rim<Real>& rim, const Vec3<Real>& local,
                           NearSurfaces<Real> near) const;
  void fadeOverWall(const Rim<Real>& rim, WallSample<Real>& sample) const;
  void addCorner(const std::array<NearSurface<Real>, 3>& walls, WallSample<Real>& sample) const;

  const Colliders<Real>& colliders_;
  KernelPair kernel_;
  double h_;
  double spacing_;
  double volume_;
  Real radius_;
  EdgeTable edge_;
  std::vector<Real> corner_;                 ///< what three walls share, over the distances to all
  std::vector<DistanceTable<Real>> tables_;  ///< of a flat surface, then of curved ones
  std::vector<std::size_t> table_of_;        ///< for each collider
};

}  // namespace ice_ice_baby
