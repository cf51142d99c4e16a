// What every shape of a collider answers, and the answers that most of them share.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// A surface near a point, in the frame of the shape.
template <class Real>
struct NearSurface {
  Real gap;            ///< from the point to where the centre of a particle touches, m
  Real distance;       ///< from the point to the surface itself, m; negative within the solid
  Vec3<Real> normal;   ///< out of the solid, of length 1
  Real flatness;       ///< radius of curvature over distance from its centre; 1: flat
  int axis;            ///< surfaces of a shape with different axes meet at right angles
  Vec3<Real> resting;  ///< where the centre of a particle may rest on a flat surface
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

/// Where a point is beside the rim at which the walls of an open container end.
template <class Real>
struct Rim {
  Real above;        ///< how far the point is above the rim, m
  Vec3<Real> below;  ///< the point, put just below the rim where it is above
  /// Along x and y how far it is over a wall, to which side, and how far the wall counts there.
  std::array<Real, 2> over, side, width;
};

/// A shape in its own frame is a class template with these members:
///
///   resolve(from, to)        nearest allowed end of the path of a particle's centre
///   near(point, reach)       surfaces nearer than `reach` to a point, as NearSurfaces
///   clear(from, to, margin)  1 when the path surely stays further than `margin` from where the
///                            shape would stop it; without branches, as many are asked at a time
///   faces(path, faces)       planes that the end of a path may not pass, for bodies that rest
///   turningRadius(far)       how far from the origin a rotation moves a point of the shape, m;
///                            of an infinite shape the points no further than `far` count
///   mesh(detail)             its surface as ColliderMesh
///   cast<Other>()            itself in other precision
///
/// and with those of its basis that it answers otherwise. Its measures bound the centres of
/// particles: they are those of the scene, grown by the particle radius.
template <class Real>
struct ShapeBasis {
  Real radius;  ///< of a particle, m: half the spacing

  /// Whether it encloses a space that holds water, which comes along when it jumps.
  bool hollow() const { return false; }
  /// Whether nothing can leave or enter that space.
  bool closed() const { return false; }
  bool holds(const Vec3<Real>&) const { return false; }
  /// Whether a wall between them hides a place from a point that the shape holds.
  /// @param slack how far beyond the wall's surface a place still is in view
  bool hides(const Vec3<Real>&, const Vec3<Real>&, Real) const { return false; }
  /// For a point nearer than `reach` to the height of a rim.
  std::optional<Rim<Real>> rim(const Vec3<Real>&, Real) const { return std::nullopt; }
  /// Of the whole surface, m.
  Real curvatureRadius() const { return std::numeric_limits<Real>::infinity(); }
  /// Whether particles may pass it by any way round.
  bool round() const { return false; }
  /// How deep a straight path cuts through a round shape between its ends, m; 0 or less: not.
  Real cut(const Vec3<Real>&, const Vec3<Real>&) const { return 0; }
};

}  // namespace ice_ice_baby
