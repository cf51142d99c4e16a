// Reads the triangles of a mesh file.
#pragma once

#include <string>

#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

/// Triangles of a file in memory, in the units and along the axes of the file. Polygons are
/// divided, lines and points left out, the transforms of the nodes applied.
/// @param bytes of the file
/// @param extension without the dot: stl, obj, dae or ply
/// @throws InvalidInput if they are no such mesh, or if this program was built without
/// libassimp-dev
TriangleMesh readMesh(const std::string& bytes, const std::string& extension);

}  // namespace ice_ice_baby
