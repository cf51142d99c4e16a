#include "coarse/held_particles.h"

#include <cmath>

namespace ice_ice_baby {

namespace {

/// Cosine of the angle to an axis from which on a normal is that axis.
constexpr double kAligned = 0.99999;

template <class Real>
void hold(Hold<Real>& particle, const Vec3<Real>& into) {
  int axis;
  if (std::abs(into[0]) > Real(kAligned) || std::abs(into[1]) > Real(kAligned) ||
      std::abs(into[2]) > Real(kAligned)) {
    into.cwiseAbs().maxCoeff(&axis);
    particle.free[axis] = 0;
    return;
  }
  particle.oblique.add(into);
}

}  // namespace

template <class Real>
void ObliqueHold<Real>::add(const Vec3<Real>& direction) {
  if (count == 3) return;
  const Vec3<Real> rest = project(direction);
  if (rest.squaredNorm() < Real(1e-4)) return;
  normal[std::size_t(count++)] = rest.normalized();
}

template <class Real>
Hold<Real> holdAtWalls(const Colliders<Real>& colliders, const Pose<Real>& grid, Real spacing_m,
                       const Vec3<Real>& from, const Vec3<Real>& step, Real held_m) {
  Hold<Real> particle;
  const Vec3<Real> wanted = from + grid.rotation * step;
  particle.step = grid.rotation.transpose() * (colliders.respond(from, wanted, false) - from);
  const Real touch = static_cast<Real>(kTouch_d) * spacing_m;
  const Real reach = spacing_m / 2 + touch;
  for (const MovingShape<Real>& collider : colliders) {
    const Vec3<Real> local = collider.motion.from.toLocal(from);
    const NearSurfaces<Real> near = collider.shape.near(local, reach);
    if (near.count == 0) continue;
    const Vec3<Real> carried = collider.motion.to.toWorld(local) - from;
    for (const NearSurface<Real>& surface : near) {
      const Vec3<Real> into =
          -(grid.rotation.transpose() * (collider.motion.from.rotation * surface.normal));
      const Real moved = into.dot(grid.rotation.transpose() * carried);
      if (into.dot(step) - moved > held_m) hold(particle, into);
    }
  }
  if (particle.oblique.count > 0) {
    // All in one projection: an axis that is held too is one of its normals.
    ObliqueHold<Real> all;
    for (int axis = 0; axis < 3; ++axis) {
      if (particle.free[axis] == 0) all.add(Vec3<Real>::Unit(axis));
    }
    for (int k = 0; k < particle.oblique.count; ++k)
      all.add(particle.oblique.normal[std::size_t(k)]);
    particle.oblique = all;
    particle.free.setOnes();
  }
  return particle;
}

template struct ObliqueHold<float>;
template struct ObliqueHold<double>;
template struct Hold<float>;
template struct Hold<double>;
template Hold<float> holdAtWalls(const Colliders<float>&, const Pose<float>&, float,
                                 const Vec3<float>&, const Vec3<float>&, float);
template Hold<double> holdAtWalls(const Colliders<double>&, const Pose<double>&, double,
                                  const Vec3<double>&, const Vec3<double>&, double);

}  // namespace ice_ice_baby
