#include "thermal/adiabatic_mirrors.h"

#include <cmath>

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
    for (std::size_t k = 0; k < colliders_.containers.size(); ++k) {
      const auto& body = colliders_.containers[k];
      if (!body.shape.inside(body.motion.to.toLocal(x.at(i)))) continue;
      owner_[i] = static_cast<int>(k);
      return;
    }
  });
}

template <class Real>
void AdiabaticMirrors<Real>::push(Faces& faces, const Face& face, const Vec3<Real>& point) const {
  if (faces.count == int(faces.faces.size())) return;
  Face& added = faces.faces[std::size_t(faces.count++)];
  added = face;
  added.distance = distanceTo(face, point);
}

/// Whether a plate with a temperature lies flush with a wall at a point of it.
template <class Real>
bool AdiabaticMirrors<Real>::coveredByPlate(const Vec3<Real>& foot,
                                            const Vec3<Real>& inward) const {
  const Real hair = Real(1e-3) * radius_;
  for (std::size_t k = 0; k < colliders_.planes.size(); ++k) {
    if (walls_.mirrors(colliders_.containers.size() + k)) continue;
    const auto& plate = colliders_.planes[k];
    if (plate.motion.to.rotation.col(2).dot(inward) < Real(0.999)) continue;
    if (std::abs(heightAbove(plate, Vec3<Real>(foot + hair * inward), radius_)) < 3 * hair) {
      return true;
    }
  }
  return false;
}

template <class Real>
typename AdiabaticMirrors<Real>::Faces AdiabaticMirrors<Real>::near(std::size_t i,
                                                                    const Vec3<Real>& point) const {
  Faces faces;
  if (owner_[i] != kNone) {
    const auto k = static_cast<std::size_t>(owner_[i]);
    if (!walls_.mirrors(k)) return faces;
    const auto& body = colliders_.containers[k];
    const Pose<Real>& pose = body.motion.to;
    for (const NearWall<Real>& wall :
         nearWalls(body.shape, pose.toLocal(point), radius_, support_)) {
      const Vec3<Real> corner = wall.sign > 0 ? body.shape.inner.low : body.shape.inner.high;
      const Vec3<Real> inward = wall.sign * pose.rotation.col(wall.axis);
      if (coveredByPlate(point - wall.distance * inward, inward)) continue;
      push(faces, {inward, pose.toWorld(corner) - radius_ * inward, wall.axis, 0, 0}, point);
    }
    return faces;
  }
  for (std::size_t k = 0; k < colliders_.planes.size(); ++k) {
    if (!walls_.mirrors(colliders_.containers.size() + k)) continue;
    const auto& body = colliders_.planes[k];
    const Real height = heightAbove(body, point, radius_);
    if (height < 0 || height >= support_) continue;
    const Vec3<Real> normal = body.motion.to.rotation.col(2);
    const Vec3<Real> origin = body.motion.to.position + (body.shape.surface - radius_) * normal;
    push(faces, {normal, origin, 2, k, 0}, point);
  }
  return faces;
}

template class AdiabaticMirrors<float>;
template class AdiabaticMirrors<double>;

}  // namespace ice_ice_baby
