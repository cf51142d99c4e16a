// How a surface of triangles bends.
#pragma once

#include <vector>

#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

/// Edges at which a surface turns by more than this are sharp: they belong to its shape and not to
/// the curved surface that the triangles stand for.
constexpr double kSharpEdge_deg = 30.0;

/// Divergence of the normal over each triangle, 1/m: 1 / R on a cylinder, 2 / R on a ball, below 0
/// where the surface bends inwards. From the angles at its edges, without sharp and open ones.
std::vector<double> bendingOf(const TriangleMesh& mesh);

}  // namespace ice_ice_baby
