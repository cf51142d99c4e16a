// Bounds, centre, spread and momenta of all particles.
#pragma once

#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Everything except the momenta is NaN for an empty cloud. Sums run in id order, in double.
struct CloudMoments {
  Vec3d min_m, max_m;              ///< of the particles' centres
  Vec3d mean_m;                    ///< centre of mass
  Vec3d rms_m;                     ///< root mean square distance from the mean along each axis
  Vec3d momentum_kg_m_s;           ///< sum over the particles
  Vec3d angular_momentum_kg_m2_s;  ///< sum over the particles, about the centre of mass
};

/// @param mass_kg of one particle
CloudMoments momentsOf(const std::vector<ParticleSample>& particles, double mass_kg);

/// Mass of one particle of the scene, kg.
double massOfParticle_kg(const Scene& scene);

inline Vec3d positionOf(const ParticleSample& p) { return {p.x, p.y, p.z}; }
inline Vec3d velocityOf(const ParticleSample& p) { return {p.vx, p.vy, p.vz}; }

}  // namespace ice_ice_baby
