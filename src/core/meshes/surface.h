// A triangle surface as contact and density see it.
#pragma once

#include <memory>
#include <optional>

#include "meshes/mesh_topology.h"
#include "meshes/surface_distance.h"
#include "meshes/surface_tree.h"

namespace ice_ice_baby {

/// Immutable, so that all who need it share one.
class Surface : public std::enable_shared_from_this<Surface> {
 public:
  /// The surface of these triangles, one of an earlier scene if it is kept. Errors as below.
  static std::shared_ptr<const Surface> shared(TriangleMesh mesh, double radius_m);

  /// @param mesh not empty, without triangles that have no area
  /// @param radius_m of a particle; 0: only answers where things are, and never fast
  /// @throws InvalidInput if it is too large for the spacing
  Surface(TriangleMesh mesh, double radius_m);

  const TriangleMesh& mesh() const { return mesh_; }
  const SurfaceTree& tree() const { return tree_; }
  const MeshTopology& topology() const { return topology_; }
  double radius_m() const { return radius_m_; }
  /// Distance of its farthest vertex from the origin, m.
  double reach_m() const { return reach_m_; }

  /// Whether a point lies in the solid that a closed surface encloses; never for an open one.
  bool encloses(const Vec3d& point) const;
  /// Whether the surface stands around a point: seen along five of the six axes at least.
  bool surrounds(const Vec3d& point) const;

  /// Square root of the area of the surface at a point of it over that of the parallel surface
  /// through x; 0 beside a sharp edge or a corner.
  double flatness(const SurfacePoint& near, const Vec3d& x) const;

  SurfacePoint closest(const Vec3d& point, double reach_m) const {
    return distance_ ? distance_->closest(tree_, point, reach_m) : tree_.closest(point, reach_m);
  }
  /// What the distance of a point from the surface is at least, m.
  template <class Real>
  Real atLeast(const Vec3<Real>& point) const {
    if (distance_) return distance_->atLeast(point);
    return static_cast<Real>(tree_.bounds().exteriorDistance(point.template cast<double>()));
  }

  std::size_t bytes() const;

 private:
  TriangleMesh mesh_;
  SurfaceTree tree_;
  MeshTopology topology_;
  std::vector<double> bending_;  ///< of each triangle
  double radius_m_;
  double reach_m_ = 0.0;
  std::optional<SurfaceDistance> distance_;
};

}  // namespace ice_ice_baby
