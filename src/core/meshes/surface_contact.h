// Where a moving particle ends beside a surface that it cannot pass.
#pragma once

#include "meshes/surface.h"

namespace ice_ice_baby {

/// End of the path of a particle's centre: at least a radius away from the surface, on the side on
/// which it started, sliding along what it meets.
///
/// It advances by no more than the distance to the surface, so no path passes it, whatever the
/// surface is like: thin, open, or with triangles that face the wrong way. In a gap that is too
/// narrow the particle stays between both sides.
Vec3d endBeside(const Surface& surface, const Vec3d& from, const Vec3d& to);

}  // namespace ice_ice_baby
