// Adiabatic walls as mirrors: behind them the water continues with the mirrored temperatures, so
// that heat flows along a wall as it does in the bulk.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "particles/particles.h"
#include "thermal/thermal_boundaries.h"

namespace ice_ice_baby {

/// Flat faces only. A particle in a container is mirrored at the faces of that container; a
/// particle outside all containers is mirrored at the flat faces of all colliders.
template <class Real>
class AdiabaticMirrors {
 public:
  struct Face {
    Vec3<Real> normal;
    Vec3<Real> origin;     ///< some point of the face
    int axis;              ///< in the frame of the collider
    std::size_t collider;  ///< its number
    Real distance;         ///< of the particle that sees it, m
  };
  struct Faces {
    std::array<Face, 8> faces;
    int count = 0;
  };

  AdiabaticMirrors(const Colliders<Real>& colliders, const ThermalBoundaries<Real>& walls,
                   const ConductionLattice& lattice);

  /// Finds the container that holds each particle.
  void locate(const VectorField<Real>& x);

  /// Faces closer than the support radius.
  Faces near(std::size_t i, const Vec3<Real>& point) const;

  /// Calls visit(r^2) for each mirror image of particle j whose distance r to the particle of
  /// `faces` is less than the support radius. Symmetric to the last bit.
  /// @param distance2 square of the distance to j itself, m^2
  template <class Visit>
  void forEachImage(const Faces& faces, std::size_t i, std::size_t j, const Vec3<Real>& point,
                    Real distance2, const Visit& visit) const;

  std::size_t bytes() const { return owner_.capacity() * sizeof(int); }

 private:
  static constexpr int kNone = -1;
  static constexpr Real kSame = Real(0.999);  ///< cosine from which on two normals are the same

  /// Edges and corners of a shape with flat faces do not mirror.
  static bool isFace(const NearSurface<Real>& surface) { return surface.flatness == 1; }

  static Real distanceTo(const Face& face, const Vec3<Real>& point) {
    return std::max(face.normal.dot(point - face.origin), Real(0));
  }
  bool over(const Face& face, const Vec3<Real>& point) const;
  bool coveredByPlate(const Vec3<Real>& foot, const Vec3<Real>& inward) const;
  void add(Faces& faces, std::size_t collider, const NearSurface<Real>& surface,
           const Vec3<Real>& point) const;

  const Colliders<Real>& colliders_;
  const ThermalBoundaries<Real>& walls_;
  Real radius_;
  Real support_;
  std::vector<int> owner_;  ///< (n) collider that holds the particle, or kNone
};

template <class Real>
template <class Visit>
void AdiabaticMirrors<Real>::forEachImage(const Faces& faces, std::size_t i, std::size_t j,
                                          const Vec3<Real>& point, Real distance2,
                                          const Visit& visit) const {
  if (owner_[i] != owner_[j]) return;
  const Real reach2 = support_ * support_;
  std::array<Real, 8> further;  // added by each face to the squared distance
  for (int a = 0; a < faces.count; ++a) {
    const Face& face = faces.faces[std::size_t(a)];
    const bool beside = owner_[i] == kNone && !over(face, point);
    const Real add = 4 * face.distance * distanceTo(face, point);
    further[std::size_t(a)] = beside ? reach2 : add;
  }
  // Each subset of walls at right angles has its own image.
  for (int a = 0; a < faces.count; ++a) {
    const Real one = distance2 + further[std::size_t(a)];
    if (one >= reach2) continue;
    visit(one);
    if (owner_[i] == kNone) continue;
    for (int b = a + 1; b < faces.count; ++b) {
      const Real two = one + further[std::size_t(b)];
      if (two >= reach2 || faces.faces[std::size_t(b)].axis == faces.faces[std::size_t(a)].axis) {
        continue;
      }
      visit(two);
      for (int c = b + 1; c < faces.count; ++c) {
        const Real three = two + further[std::size_t(c)];
        const bool apart = faces.faces[std::size_t(c)].axis != faces.faces[std::size_t(b)].axis;
        if (three < reach2 && apart) visit(three);
      }
    }
  }
}

}  // namespace ice_ice_baby
