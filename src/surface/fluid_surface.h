// The surface of water or of ice as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ice_ice_baby/samples.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// What a surface holds besides its shape.
enum class SurfaceValues { kShapeOnly, kAll };

/// Closed and oriented; empty where there are no such particles.
struct FluidSurface {
  std::vector<Vec3<float>> vertices;            ///< m
  std::vector<Vec3<float>> normals;             ///< outwards, of unit length
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise as seen from outside
  /// Of each vertex, if they are asked for.
  std::vector<Vec3<float>> velocities;  ///< m/s
  std::vector<float> temperatures_c;    ///< degrees Celsius
  std::vector<float> ice_fractions;     ///< by mass, 0 ... 1
  std::vector<std::uint32_t> colours;   ///< 0x00RRGGBB, for files; set by who writes them

  /// Enclosed volume, m^3, and area, m^2.
  double volume_m3() const;
  double area_m2() const;
};

/// Whether this program was built with libopenvdb-dev, without which surfaces are refused.
bool makesSurfaces();

/// Surface of the particles of one phase. A flat one lies half a spacing above the top layer.
/// @param spacing_m of the particles
/// @throws InvalidInput if this program makes no surfaces
FluidSurface surfaceOf(const std::vector<ParticleSample>& particles, Phase phase, double spacing_m,
                       SurfaceValues values = SurfaceValues::kAll);

}  // namespace ice_ice_baby
