#include "spawn/solids.h"

namespace ice_ice_baby {

namespace {

/// Penetration below this is rounding error, m.
constexpr double kHair_m = 1e-6;

}  // namespace

Solids::Solids(const Scene& scene, double radius_m) : colliders_(scene, radius_m) {
  faces_.take(colliders_);
}

bool Solids::near(std::size_t k, const Eigen::AlignedBox3d& box) const {
  return faces_.near(k, box.center(), box.center(), box.diagonal().norm() / 2);
}

bool Solids::reached(std::size_t k, const Vec3d& x) const {
  return faces_.push(k, x, x).norm() > kHair_m;
}

bool Solids::holds(std::size_t k, const Vec3d& x) const {
  return colliders_[k].shape.holds(faces_.motion(k).to.toLocal(x));
}

}  // namespace ice_ice_baby
