// Single particles and springs as the outside sees them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// With heat, particles change phase with hysteresis (thermal.hysteresis_c) and only once the
/// latent heat is gone or back, so the ice fraction does not tell the phase: slush that flows is
/// water with ice in it, and ice that melts is ice until all of it has melted. Without heat every
/// particle is ice while the whole scene is frozen, and water otherwise.
enum class Phase : std::uint8_t { kWater, kIce, kSteam };

constexpr Phase kPhases[] = {Phase::kWater, Phase::kIce, Phase::kSteam};

inline std::vector<std::string> choices(Phase) { return {"water", "ice", "steam"}; }

/// One particle.
struct ParticleSample {
  float x, y, z;     ///< m
  float vx, vy, vz;  ///< m/s
  float temperature_c;
  float ice_fraction;  ///< by mass, 0 ... 1; without heat the strictness of the springs
  float density;      ///< relative to rest density, measured with the solver's own kernel; of steam
                      ///< always that at 100 degrees C and 1 bar, 6e-4
  float pressure_pa;  ///< equivalent to the solver's corrections in the latest substep
  std::uint32_t id;
  Phase phase = Phase::kWater;
  std::uint8_t unused[3] = {};  ///< zero, so that copied bytes are always the same
};

/// Ends of a spring as positions in m.
struct SpringSample {
  float ax, ay, az;
  float bx, by, bz;
};

}  // namespace ice_ice_baby
