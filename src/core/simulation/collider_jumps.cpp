#include "simulation/collider_jumps.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "colliders/clearance.h"

namespace ice_ice_baby {

template <class Real>
std::vector<Jump<Real>> jumpFastColliders(Colliders<Real>& colliders,
                                          const Particles<Real>& particles, double max_m) {
  double far2 = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    far2 = std::max(far2, double(particles.position.at(i).squaredNorm()));
  }
  return colliders.jump(max_m, std::sqrt(far2));
}

template <class Real>
std::size_t carry(const std::vector<Jump<Real>>& jumps, const Colliders<Real>& colliders,
                  const IceBodies<Real>* bodies, Particles<Real>& particles) {
  std::size_t carried = 0;
  for (Index i = 0; i < particles.size(); ++i) {
    if (bodies && bodies->memberAt(i) != kNone) continue;
    for (const Jump<Real>& jump : jumps) {
      const Vec3<Real> local = jump.motion.from.toLocal(particles.position.at(i));
      if (!colliders[jump.number].shape.holds(local)) continue;
      const Mat3<Real> rotation = jump.motion.to.rotation * jump.motion.from.rotation.transpose();
      particles.position.set(i, jump.motion.to.toWorld(local));
      particles.velocity.set(i, rotation * particles.velocity.at(i));
      ++carried;
      break;
    }
  }
  particles.predicted = particles.position;
  return carried;
}

template <class Real>
double expel(const Colliders<Real>& colliders, const IceBodies<Real>* bodies,
             Particles<Real>& particles) {
  double farthest = 0.0;
  const Paths<Real> paths{particles.position, particles.position};
  forEachNear(colliders, paths, Real(0), 0, particles.size(), [&](std::size_t i) {
    if (bodies && bodies->memberAt(Index(i)) != kNone) return;
    const Vec3<Real> from = particles.position.at(i);
    const Vec3<Real> end = colliders.respond(from, from, false);
    farthest = std::max(farthest, double((end - from).norm()));
    particles.position.set(i, end);
    particles.predicted.set(i, end);
  });
  return farthest;
}

template std::vector<Jump<float>> jumpFastColliders(Colliders<float>&, const Particles<float>&,
                                                    double);
template std::size_t carry(const std::vector<Jump<float>>&, const Colliders<float>&,
                           const IceBodies<float>*, Particles<float>&);
template double expel(const Colliders<float>&, const IceBodies<float>*, Particles<float>&);
template std::vector<Jump<double>> jumpFastColliders(Colliders<double>&, const Particles<double>&,
                                                     double);
template std::size_t carry(const std::vector<Jump<double>>&, const Colliders<double>&,
                           const IceBodies<double>*, Particles<double>&);
template double expel(const Colliders<double>&, const IceBodies<double>*, Particles<double>&);

}  // namespace ice_ice_baby
