// The mesh on which a smoothed volume has the value of the surface.
#pragma once

#include "fluid_surface.h"
#include "smoothed_volume.h"

namespace ice_ice_baby {

/// Vertices and triangles only. @throws InvalidInput without libopenvdb-dev
FluidSurface levelMesh(const SmoothedVolume& volume);

}  // namespace ice_ice_baby
