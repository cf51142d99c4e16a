// Round solids as triangles, around the z axis.
#pragma once

#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

/// A point of an outline: distance from the axis and height, m.
struct OutlinePoint {
  double radius_m;
  double z_m;
};

/// Turns an outline around the axis. The outline starts and ends on the axis and has the solid on
/// its left. The triangles hold as much as the round solid does.
/// @param segments around the axis, at least 3
TriangleMesh turned(const std::vector<OutlinePoint>& outline, int segments);

/// So many segments that a circle and its polygon differ by about 0.1 mm, within 48 and 256.
int segmentsOf(double radius_m);

/// From -height / 2 to height / 2.
TriangleMesh cylinderMesh(double radius_m, double height_m);
/// A cylinder from -length / 2 to length / 2 with a half ball at each end.
TriangleMesh capsuleMesh(double radius_m, double length_m);
/// An open round container: the middle of its inner floor is the origin.
TriangleMesh cupMesh(double inner_radius_m, double depth_m, double wall_m);

}  // namespace ice_ice_baby
