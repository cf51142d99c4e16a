#include "metrics/cloud_moments.h"

#include <limits>

#include "particles/kernels.h"

namespace ice_ice_baby {

CloudMoments momentsOf(const std::vector<ParticleSample>& particles, double mass_kg) {
  const Vec3d nowhere = Vec3d::Constant(std::numeric_limits<double>::quiet_NaN());
  CloudMoments m{nowhere, nowhere, nowhere, nowhere, Vec3d::Zero(), Vec3d::Zero()};
  if (particles.empty()) return m;
  m.min_m = m.max_m = positionOf(particles.front());
  m.mean_m.setZero();
  for (const ParticleSample& p : particles) {
    const Vec3d x = positionOf(p);
    m.min_m = m.min_m.cwiseMin(x);
    m.max_m = m.max_m.cwiseMax(x);
    m.mean_m += x;
    m.momentum_kg_m_s += mass_kg * velocityOf(p);
  }
  const double count = double(particles.size());
  m.mean_m /= count;
  Vec3d squares = Vec3d::Zero();
  for (const ParticleSample& p : particles) {
    const Vec3d arm = positionOf(p) - m.mean_m;
    squares += arm.cwiseAbs2();
    m.angular_momentum_kg_m2_s += mass_kg * arm.cross(velocityOf(p));
  }
  m.rms_m = (squares / count).cwiseSqrt();
  return m;
}

double massOfParticle_kg(const Scene& scene) {
  return particleMass_kg(scene.fluid, scene.supportRadius_m());
}

}  // namespace ice_ice_baby
