// Single faces of colliders, for bodies that rest on several at once.
#pragma once

#include <array>
#include <vector>

#include "colliders/colliders.h"

namespace ice_ice_baby {

/// The colliders in double precision, with the same indices.
class ColliderFaces {
 public:
  /// Copies the poses of the colliders in this substep.
  template <class Real>
  void take(const Colliders<Real>& colliders);

  std::size_t count() const { return all_.size(); }
  double friction(std::size_t k) const { return all_[k].friction; }
  const Motion<double>& motion(std::size_t k) const { return all_[k].motion; }
  bool moves(std::size_t k) const { return all_[k].moves; }
  bool hollow(std::size_t k) const { return all_[k].shape.hollow(); }

  /// Whether points within `radius_m` of a path may come near the collider.
  bool near(std::size_t k, const Vec3d& from, const Vec3d& to, double radius_m) const;

  /// Displacement that moves the end of a path out of the collider.
  Vec3d push(std::size_t k, const Vec3d& from, const Vec3d& to) const;

  /// Faces that a path from `from` to `to` crosses, or ends closer to than `margin_m`.
  /// @return number of faces
  std::size_t find(std::size_t k, const Vec3d& from, const Vec3d& to, double margin_m,
                   std::array<Face, 6>& faces) const;

 private:
  struct Entry {
    Motion<double> motion;
    double friction;
    bool moves;
    Shape<double> shape;
  };

  std::vector<Entry> all_;
};

}  // namespace ice_ice_baby
