// Faces of colliders one by one, for bodies that rest on several at once.
#pragma once

#include <array>
#include <vector>

#include "colliders/colliders.h"

namespace ice_ice_baby {

/// The colliders in double, with the same numbers.
class ColliderFaces {
 public:
  /// Takes over where the colliders are in this substep.
  template <class Real>
  void take(const Colliders<Real>& colliders);

  std::size_t count() const { return all_.size(); }
  double friction(std::size_t k) const { return all_[k].friction; }
  const Motion<double>& motion(std::size_t k) const { return all_[k].motion; }
  bool moves(std::size_t k) const { return all_[k].moves; }
  bool hollow(std::size_t k) const { return all_[k].shape.hollow(); }

  /// Whether points that stay within `radius_m` of a path may come near.
  bool near(std::size_t k, const Vec3d& from, const Vec3d& to, double radius_m) const;

  /// How far and where to a path that ends in the collider is pushed out of it.
  Vec3d push(std::size_t k, const Vec3d& from, const Vec3d& to) const;

  /// Faces that a path from `from` to `to` passes or ends nearer to than `margin_m`.
  /// @return how many
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
