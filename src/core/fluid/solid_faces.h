// Faces and boxes that solids show to a point, to count what two solids share once.
#pragma once

#include <array>

#include "colliders/aligned_box.h"
#include "colliders/distance_table.h"
#include "fluid/overlap_density.h"
#include "fluid/wall_sample.h"

namespace ice_ice_baby {

/// The plane through the point of a solid that is closest to a particle.
template <class Real>
struct SolidFace {
  Real distance;                                   ///< m
  Vec3<Real> normal;                               ///< away from the solid
  Mat3<Real> turning = Mat3<Real>::Zero();         ///< derivative of the normal by the point, 1/m
  Real share = 1;                                  ///< density of the solid over that of the plane
  Vec3<Real> share_gradient = Vec3<Real>::Zero();  ///< 1/m
  bool flat = false;                               ///< the solid is the half space behind the plane
};

/// A list that leaves out what exceeds its capacity.
template <class Item, std::size_t kMax>
class ShortList {
 public:
  void add(const Item& item) {
    if (count_ < kMax) list_[count_++] = item;
  }
  std::size_t count() const { return count_; }
  const Item* begin() const { return list_.data(); }
  const Item* end() const { return list_.data() + count_; }

 private:
  std::array<Item, kMax> list_;
  std::size_t count_ = 0;
};

/// A box relative to the point, and the axes of its frame.
template <class Real>
struct SolidBox {
  AlignedBox<Real> box;
  Mat3<Real> axes;   ///< columns, in the frame of the scene
  std::size_t face;  ///< index of its face
};

/// What a point has seen of the solids so far.
template <class Real>
struct SeenSolids {
  static constexpr std::size_t kMaxFaces = 16, kMaxBoxes = 8;

  bool alone = false;  ///< whether a single solid is near, so that none shares anything
  ShortList<SolidFace<Real>, kMaxFaces> faces;
  ShortList<SolidBox<Real>, kMaxBoxes> boxes;
};

/// Cuts off what lies behind a flat face.
/// @returns whether the face is parallel to a side of the box; nothing is cut otherwise
template <class Real>
bool cutBehind(const SolidFace<Real>& face, SolidBox<Real>& box);

/// The part of a box that lies in another one, in the frame of the latter; empty where they do not
/// meet. @returns whether their axes are parallel
template <class Real>
bool commonPart(const SolidBox<Real>& a, const SolidBox<Real>& b, AlignedBox<Real>& common);

/// Subtracts from the density of a solid the part of it that lies behind the face of another solid,
/// as if both were planes.
/// @param solid density of the solid that is left
/// @param face of that solid
/// @param flat density of a flat wall over the distance to it
template <class Real>
void takeOff(const SolidFace<Real>& other, const SolidFace<Real>& face,
             const OverlapDensity<Real>& overlap, const DistanceTable<Real>& flat,
             WallSample<Real>& solid);

}  // namespace ice_ice_baby
