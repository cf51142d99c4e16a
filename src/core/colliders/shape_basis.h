// The members that every collider shape has, and defaults for those that most shapes share.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "colliders/aligned_box.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

class Surface;

/// A surface near a point, in the frame of the shape.
template <class Real>
struct NearSurface {
  Real gap;            ///< from the point to the position of a touching particle, m
  Real distance;       ///< from the point to the surface, m; negative inside the solid
  Vec3<Real> normal;   ///< outward unit normal
  Real flatness;       ///< square root of the area of a piece of it over that of the parallel
                       ///< surface through the point; 1: flat, 0: edge or corner
  int axis;            ///< surfaces of a shape with different axes meet at right angles
  Vec3<Real> resting;  ///< position of a particle centre at rest on a flat surface
};

template <class Real>
struct NearSurfaces {
  std::array<NearSurface<Real>, 6> list;
  int count = 0;

  void add(const NearSurface<Real>& surface) { list[std::size_t(count++)] = surface; }
  const NearSurface<Real>* begin() const { return list.data(); }
  const NearSurface<Real>* end() const { return list.data() + count; }
  NearSurface<Real>* begin() { return list.data(); }
  NearSurface<Real>* end() { return list.data() + count; }
};

/// Position of a point relative to the rim of an open container.
template <class Real>
struct Rim {
  Real above;        ///< height above the rim, m
  Vec3<Real> below;  ///< the point, moved just below the rim if it is above
  /// Along x and y: distance over the wall, side, and width over which the wall counts.
  std::array<Real, 2> over, side, width;
};

/// A shape in its own frame is a class template with these members:
///
///   resolve(from, to)        nearest allowed end of the path of a particle's centre
///   near(point, reach)       surfaces closer than `reach` to a point, as NearSurfaces
///   solid(point)             whether a point lies in its material
///   clear(from, to, margin)  1 if the path certainly stays farther than `margin` from the shape;
///                            branch-free, because many paths are tested at a time
///   faces(path, faces)       planes that the end of a path may not cross, for resting bodies
///   turningRadius(far)       largest distance of a point of the shape from its origin, m; in an
///                            infinite shape only points closer than `far` count
///   mesh(detail)             its surface as ColliderMesh
///   cast<Other>()            itself in other precision
///
/// and overrides of ShapeBasis where needed. Its dimensions bound particle centres: they are those
/// of the scene plus the particle radius.
template <class Real>
struct ShapeBasis {
  Real radius;  ///< particle radius, m: half the spacing

  /// Whether it can hold water, which moves along when it jumps.
  bool hollow() const { return false; }
  /// Whether no particle can enter or leave it.
  bool closed() const { return false; }
  bool holds(const Vec3<Real>&) const { return false; }
  /// The space between the flat walls of a hollow shape, infinite where it is open.
  AlignedBox<Real> room() const {
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    return {Vec3<Real>::Zero(), Vec3<Real>::Constant(kInfinity)};
  }
  /// Whether a wall separates `place` from a point inside the shape.
  /// @param slack depth behind the wall surface up to which a place still counts as inside
  bool hides(const Vec3<Real>&, const Vec3<Real>&, Real) const { return false; }
  /// The rim, for a point closer than `reach` to its height.
  std::optional<Rim<Real>> rim(const Vec3<Real>&, Real) const { return std::nullopt; }
  /// The solid, if it is a box, in the dimensions of the scene.
  std::optional<AlignedBox<Real>> box() const { return std::nullopt; }
  /// Its triangles, if it is made of them.
  const Surface* triangleSurface() const { return nullptr; }
  /// Radius of curvature of the whole surface, m.
  Real curvatureRadius() const { return std::numeric_limits<Real>::infinity(); }
  /// Whether particles may slide around it in any direction.
  bool round() const { return false; }
  /// Depth to which a straight path cuts through a round shape between its ends, m; at most 0 if it
  /// does not.
  Real cut(const Vec3<Real>&, const Vec3<Real>&) const { return 0; }
};

}  // namespace ice_ice_baby
