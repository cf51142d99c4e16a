#include "ice_ice_baby/errors.h"
#include "level_mesh.h"

namespace ice_ice_baby {

bool makesSurfaces() { return false; }

FluidSurface levelMesh(const SmoothedVolume&) {
  throw InvalidInput("surfaces need libopenvdb-dev; install it and build again");
}

}  // namespace ice_ice_baby
