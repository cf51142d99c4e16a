// Files of surfaces that other programs read.
#pragma once

#include <string>

#include "fluid_surface.h"

namespace ice_ice_baby {

/// Binary PLY with the normal of each vertex and, if the surface has them, velocity, `temperature`
/// and `ice`, and colours.
/// @throws InvalidInput if the file cannot be written
void writePly(const std::string& path, const FluidSurface& surface);

/// Wavefront OBJ with normals; the format has no place for other values.
/// @throws InvalidInput if the file cannot be written
void writeObj(const std::string& path, const FluidSurface& surface);

}  // namespace ice_ice_baby
