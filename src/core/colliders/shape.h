// The shape of a collider as a variant. shape_basis.h lists the members that each shape has.
#pragma once

#include <utility>
#include <variant>

#include "colliders/box_shape.h"
#include "colliders/container_shape.h"
#include "colliders/mesh_shape.h"
#include "colliders/path_tile.h"
#include "colliders/plane_shape.h"
#include "colliders/sphere_shape.h"

namespace ice_ice_baby {

template <class Real>
class Shape {
 public:
  using Any = std::variant<ContainerShape<Real>, PlaneShape<Real>, SphereShape<Real>,
                           BoxShape<Real>, MeshShape<Real>>;

  explicit Shape(Any any) : any_(std::move(any)) {}

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
    return ask([&](const auto& shape) { return shape.resolve(from, to); });
  }
  NearSurfaces<Real> near(const Vec3<Real>& point, Real reach_m) const {
    return ask([&](const auto& shape) { return shape.near(point, reach_m); });
  }
  bool clear(const Vec3<Real>& from, const Vec3<Real>& to, Real margin_m) const {
    return ask([&](const auto& shape) { return shape.clear(from, to, margin_m) != 0; });
  }
  /// Clears the entries of the mask whose paths are not clear.
  void clear(const PathTile<Real>& paths, ClearMask& mask) const {
    ask([&](const auto& shape) {
      for (std::size_t k = 0; k < kClearanceTile; ++k) {
        mask[k] &= shape.clear(paths.from.at(k), paths.to.at(k), paths.margin_m);
      }
    });
  }
  void faces(const PushedPath& path, FaceCollector& faces) const {
    ask([&](const auto& shape) { shape.faces(path, faces); });
  }
  double turningRadius(double far_m) const {
    return ask([&](const auto& shape) { return shape.turningRadius(far_m); });
  }
  ColliderMesh mesh(const MeshDetail& detail) const {
    return ask([&](const auto& shape) { return shape.mesh(detail); });
  }

  bool hollow() const {
    return ask([](const auto& shape) { return shape.hollow(); });
  }
  bool closed() const {
    return ask([](const auto& shape) { return shape.closed(); });
  }
  bool holds(const Vec3<Real>& point) const {
    return ask([&](const auto& shape) { return shape.holds(point); });
  }
  bool solid(const Vec3<Real>& point) const {
    return ask([&](const auto& shape) { return shape.solid(point); });
  }
  AlignedBox<Real> room() const {
    return ask([](const auto& shape) { return shape.room(); });
  }
  Real particleRadius() const {
    return ask([](const auto& shape) { return shape.radius; });
  }
  bool hides(const Vec3<Real>& point, const Vec3<Real>& place, Real slack_m) const {
    return ask([&](const auto& shape) { return shape.hides(point, place, slack_m); });
  }
  std::optional<Rim<Real>> rim(const Vec3<Real>& point, Real reach_m) const {
    return ask([&](const auto& shape) { return shape.rim(point, reach_m); });
  }
  std::optional<AlignedBox<Real>> box() const {
    return ask([](const auto& shape) { return shape.box(); });
  }
  const Surface* triangleSurface() const {
    return ask([](const auto& shape) { return shape.triangleSurface(); });
  }
  Real curvatureRadius() const {
    return ask([](const auto& shape) { return shape.curvatureRadius(); });
  }
  bool flat() const { return curvatureRadius() == std::numeric_limits<Real>::infinity(); }
  bool round() const {
    return ask([](const auto& shape) { return shape.round(); });
  }
  Real cut(const Vec3<Real>& from, const Vec3<Real>& to) const {
    return ask([&](const auto& shape) { return shape.cut(from, to); });
  }

  template <class Other>
  Shape<Other> cast() const {
    return Shape<Other>(ask([](const auto& shape) {
      return typename Shape<Other>::Any(shape.template cast<Other>());
    }));
  }

 private:
  template <class Question>
  decltype(auto) ask(const Question& question) const {
    return std::visit(question, any_);
  }

  Any any_;
};

}  // namespace ice_ice_baby
