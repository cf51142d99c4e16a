// Density that colliders add to particles near them. Without it particles stack at walls.
//
// A solid adds the integral over its volume of a kernel calibrated to the flat wall (WallKernel),
// so edges, corners and round surfaces follow from one function of the position alone. What two
// solids share counts once. The walls of a container are those of ContainerDensity.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "colliders/clearance.h"
#include "colliders/colliders.h"
#include "colliders/distance_table.h"
#include "fluid/box_density.h"
#include "fluid/container_density.h"
#include "fluid/solid_faces.h"
#include "fluid/surface_density.h"

namespace ice_ice_baby {

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
    const Real margin = support_ - radius_;
    ice_ice_baby::forEachNear(colliders_, Paths<Real>{points, points}, margin, first, last,
                              [&](std::size_t i) { visit(i, at(points.at(i))); });
  }

  /// The same for the parts of single colliders: visit(i, collider, sample).
  template <class Visit>
  void forEachPart(const VectorField<Real>& points, const Visit& visit) const {
    const auto visitNear = [&](std::size_t i) {
      SeenSolids<Real> seen;
      for (const std::size_t collider : order_) {
        if (!isNear(collider, points.at(i))) continue;
        visit(i, collider, of(collider, points.at(i), seen));
      }
    };
    ice_ice_baby::forEachNear(colliders_, Paths<Real>{points, points}, support_ - radius_, 0,
                              points.size(), visitNear);
  }

  std::size_t bytes() const;

 private:
  struct Ball {
    Real radius;
    DistanceTable<Real> table;  ///< density over the distance from its surface
  };
  struct Triangles {
    const Surface* surface;
    std::shared_ptr<const SurfaceDensity<Real>> density;
  };
  void sortColliders();
  void buildTables(const RestLattice& lattice);
  bool isNear(std::size_t collider, const Vec3<Real>& point) const;
  WallSample<Real> of(std::size_t collider, const Vec3<Real>& point, SeenSolids<Real>& seen) const;
  WallSample<Real> ofContainer(std::size_t collider, const Vec3<Real>& point,
                               SeenSolids<Real>& seen) const;
  WallSample<Real> ofSurface(std::size_t collider, const Vec3<Real>& point,
                             SeenSolids<Real>& seen) const;
  WallSample<Real> ofBox(std::size_t collider, const Vec3<Real>& point,
                         SeenSolids<Real>& seen) const;
  WallSample<Real> ofTriangles(std::size_t collider, const Vec3<Real>& point,
                               SeenSolids<Real>& seen) const;
  template <class Marks>
  WallSample<Real> cutBox(const SeenSolids<Real>& seen, SolidBox<Real>& box, Marks& counted) const;
  using BoxList = ShortList<AlignedBox<Real>, SeenSolids<Real>::kMaxBoxes>;
  WallSample<Real> ofAny(const BoxList& others, std::size_t first,
                         const AlignedBox<Real>& box) const;
  SolidFace<Real> faceOf(const SolidBox<Real>& box) const;
  SolidFace<Real> faceOf(const SurfacePoint& near, const Vec3d& point,
                         const Pose<Real>& pose) const;
  void setShare(const WallSample<Real>& sample, SolidFace<Real>& face) const;

  const Colliders<Real>& colliders_;
  Real support_;
  Real radius_;
  std::unique_ptr<DistanceTable<Real>> flat_;        ///< at a fixed address
  std::optional<ContainerDensity<Real>> container_;  ///< these three: only if the scene needs them
  std::optional<BoxDensity<Real>> box_;
  std::optional<OverlapDensity<Real>> overlap_;
  std::vector<std::size_t> order_;     ///< of the colliders
  std::vector<Ball> balls_;            ///< one for each radius
  std::vector<Triangles> triangles_;   ///< one for each collider that is made of them
  std::vector<std::size_t> table_of_;  ///< for each collider, its place in balls_ or triangles_
};

}  // namespace ice_ice_baby
