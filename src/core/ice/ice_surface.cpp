// Which members of an ice body are at its surface, and where outward is.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "ice/ice_bodies.h"

namespace ice_ice_baby {

namespace {

/// Towards the faces and corners of a cube: every direction is within 36.3 degrees of one of them.
const std::array<Vec3d, 14>& lookouts() {
  static const std::array<Vec3d, 14> directions = [] {
    std::array<Vec3d, 14> all;
    for (int k = 0; k < 6; ++k) all[k] = Vec3d::Unit(k / 2) * (k % 2 ? 1.0 : -1.0);
    for (int k = 0; k < 8; ++k) {
      all[k + 6] = Vec3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized();
    }
    return all;
  }();
  return directions;
}

/// Cosine of 46 degrees. If every such cone around a lookout direction contains a neighbour, no
/// flat surface can touch the particle.
constexpr double kLookoutCosine = 0.7;

/// Neighbours up to this distance, in spacings, can hide a particle.
constexpr double kHideReach_d = 1.85;

}  // namespace

/// Computes IceBodies::outward of particle i.
/// @return whether it is hidden among particles of its label, so that nothing can touch it
template <class Real>
bool IceBodies<Real>::lookAround(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                                 const std::vector<Index>& label, Index i) {
  constexpr unsigned kHidden = (1u << 14) - 1;
  const auto reach2 = static_cast<Real>(std::pow(kHideReach_d * 2 * radius_m_, 2));
  const Vec3<Real> here = x.at(i);
  unsigned taken = 0;
  double near = 0.0;
  Vec3d sum = Vec3d::Zero();
  for (const Index j : neighbours.of(i)) {
    if (label[j] != label[i]) continue;
    const Vec3<Real> to = x.at(j) - here;
    if (to.squaredNorm() > reach2 || to.isZero(0)) continue;
    const Vec3d along = to.template cast<double>().normalized();
    sum += along;
    near += 1.0;
    if (taken == kHidden) continue;
    for (unsigned k = 0; k < 14; ++k) {
      if (along.dot(lookouts()[k]) > kLookoutCosine) taken |= 1u << k;
    }
  }
  bare_[i] = near > 0 ? Vec3d(-sum / near) : Vec3d::Zero();
  return taken == kHidden;
}

/// Moves the surface members of a new body before the hidden ones.
/// @return end of the surface members
template <class Real>
Index IceBodies<Real>::sortSurface(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                                   const std::vector<Index>& label, Index first, Index last) {
  at_surface_.resize(label.size());
  bare_.resize(label.size());
  parallelFor(last - first, [&](std::size_t k) {
    const Index i = place_[first + k];
    at_surface_[i] = !lookAround(x, neighbours, label, i);
  });
  const auto end = std::stable_partition(place_.begin() + first, place_.begin() + last,
                                         [&](Index i) { return at_surface_[i] != 0; });
  for (Index m = first; m < last; ++m) outward_[m] = bare_[place_[m]];
  return static_cast<Index>(end - place_.begin());
}

template class IceBodies<float>;
template class IceBodies<double>;

}  // namespace ice_ice_baby
