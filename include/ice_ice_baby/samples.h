// Samples of particles and springs, for drawing, topics and files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// In a thermal scene, particles change phase with hysteresis (thermal.hysteresis_c) and only after
/// exchanging the latent heat, so the phase does not follow from the ice fraction: slush that flows
/// is water, and ice that is melting is ice until all of it has melted. In other scenes every
/// particle of water is ice while the whole scene is frozen, and water otherwise. Particles of
/// floating solids are solid in any scene.
enum class Phase : std::uint8_t { kWater, kIce, kSteam, kSolid };

constexpr Phase kPhases[] = {Phase::kWater, Phase::kIce, Phase::kSteam, Phase::kSolid};

inline std::vector<std::string> choices(Phase) { return {"water", "ice", "steam", "solid"}; }

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
  std::uint8_t unused[3] = {};  ///< zero, so that bytes are reproducible
};

/// Ends of a spring as positions in m.
struct SpringSample {
  float ax, ay, az;
  float bx, by, bz;
};

}  // namespace ice_ice_baby
