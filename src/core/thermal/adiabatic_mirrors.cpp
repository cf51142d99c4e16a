#include "thermal/adiabatic_mirrors.h"

#include "base/parallel.h"

namespace ice_ice_baby {

template <class Real>
AdiabaticMirrors<Real>::AdiabaticMirrors(const Colliders<Real>& colliders,
                                         const ThermalBoundaries<Real>& walls,
                                         const ConductionLattice& lattice)
    : colliders_(colliders),
      walls_(walls),
      radius_(static_cast<Real>(lattice.spacing_m / 2)),
      support_(static_cast<Real>(lattice.support_m)) {}

template <class Real>
void AdiabaticMirrors<Real>::locate(const VectorField<Real>& x) {
  owner_.resize(x.size());
  parallelFor(x.size(), [&](std::size_t i) {
    owner_[i] = kNone;
    for (std::size_t k = 0; k < colliders_.count(); ++k) {
      const Shape<Real>& shape = colliders_[k].shape;
      if (!shape.hollow() || !shape.holds(colliders_[k].motion.to.toLocal(x.at(i)))) continue;
      owner_[i] = static_cast<int>(k);
      return;
    }
  });
}

template <class Real>
void AdiabaticMirrors<Real>::add(Faces& faces, std::size_t collider,
                                 const NearSurface<Real>& surface, const Vec3<Real>& point) const {
  if (faces.count == int(faces.faces.size())) return;
  const Pose<Real>& pose = colliders_[collider].motion.to;
  Face& added = faces.faces[std::size_t(faces.count++)];
  added.normal = pose.rotation * surface.normal;
  added.origin = pose.toWorld(surface.resting) - radius_ * added.normal;
  added.axis = surface.axis;
  added.collider = collider;
  added.distance = distanceTo(added, point);
}

/// Whether a point is above a flat face of a collider, however high, and not beside it.
template <class Real>
bool AdiabaticMirrors<Real>::over(const Face& face, const Vec3<Real>& point) const {
  const MovingShape<Real>& collider = colliders_[face.collider];
  const Vec3<Real> local = collider.motion.to.toLocal(point);
  const Vec3<Real> normal = collider.motion.to.rotation.transpose() * face.normal;
  for (const NearSurface<Real>& surface :
       collider.shape.near(local, std::numeric_limits<Real>::infinity())) {
    if (isFace(surface) && surface.normal.dot(normal) >= kSame) return true;
  }
  return false;
}

/// Whether a plate with a temperature lies flush with a wall at the given point.
template <class Real>
bool AdiabaticMirrors<Real>::coveredByPlate(const Vec3<Real>& foot,
                                            const Vec3<Real>& inward) const {
  const Real hair = Real(1e-3) * radius_;
  const Vec3<Real> before = foot + 4 * hair * inward;
  for (std::size_t k = 0; k < colliders_.count(); ++k) {
    const Shape<Real>& shape = colliders_[k].shape;
    if (walls_.mirrors(k) || shape.hollow() || !shape.flat()) continue;
    const Pose<Real>& pose = colliders_[k].motion.to;
    for (const NearSurface<Real>& near : shape.near(pose.toLocal(before), 6 * hair)) {
      if (isFace(near) && (pose.rotation * near.normal).dot(inward) >= kSame) return true;
    }
  }
  return false;
}

template <class Real>
typename AdiabaticMirrors<Real>::Faces AdiabaticMirrors<Real>::near(std::size_t i,
                                                                    const Vec3<Real>& point) const {
  Faces faces;
  const bool held = owner_[i] != kNone;
  const std::size_t first = held ? std::size_t(owner_[i]) : 0;
  const std::size_t last = held ? first + 1 : colliders_.count();
  for (std::size_t k = first; k < last; ++k) {
    const Shape<Real>& shape = colliders_[k].shape;
    if (!walls_.mirrors(k) || !shape.flat()) continue;
    const Pose<Real>& pose = colliders_[k].motion.to;
    for (const NearSurface<Real>& surface : shape.near(pose.toLocal(point), support_)) {
      if (!isFace(surface)) continue;
      const Vec3<Real> inward = pose.rotation * surface.normal;
      if (held && coveredByPlate(point - surface.distance * inward, inward)) continue;
      add(faces, k, surface, point);
    }
  }
  return faces;
}

template class AdiabaticMirrors<float>;
template class AdiabaticMirrors<double>;

}  // namespace ice_ice_baby
