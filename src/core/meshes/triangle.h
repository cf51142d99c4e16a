// A single triangle: its closest point and where a ray meets it.
#pragma once

#include <optional>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// What part of a triangle a closest point lies on.
enum class TrianglePart { kFace, kEdge, kCorner };

struct Triangle {
  Vec3d a, b, c;

  /// Not normalised; twice as long as the area.
  Vec3d normal() const { return (b - a).cross(c - a); }
  double area() const { return normal().norm() / 2; }
  Vec3d centre() const { return (a + b + c) / 3; }
};

struct TrianglePoint {
  Vec3d point;
  TrianglePart part;
  Vec3d along;  ///< direction of the edge, if it lies on one; not normalised
};

/// Point of a triangle closest to x (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5).
TrianglePoint closestPoint(const Triangle& triangle, const Vec3d& x);

/// Distance along a ray, in lengths of `direction`, at which it meets a triangle from either side
/// (T. Moeller, B. Trumbore, J. Graphics Tools 2, 1997).
/// @param margin by how much the triangle is larger, in its barycentric coordinates
std::optional<double> hit(const Triangle& triangle, const Vec3d& origin, const Vec3d& direction,
                          double margin = 0.0);

}  // namespace ice_ice_baby
