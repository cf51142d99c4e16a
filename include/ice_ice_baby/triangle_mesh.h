// Triangles of a surface.
#pragma once

#include <array>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

struct TriangleMesh {
  std::vector<Vec3d> vertices;                  ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise from outside
};

}  // namespace ice_ice_baby
