#include "fluid/rest_lattice.h"

#include "particles/kernels.h"

namespace ice_ice_baby {

namespace {

double kernelValue(KernelPair pair, double h, double r) {
  return pair == KernelPair::kCubic ? CubicSpline<double>(h).w(r) : Poly6<double>(h).w(r);
}

}  // namespace

RestLattice::RestLattice(const Scene& scene, double volume_m3)
    : kernel_(scene.fluid.kernel),
      h_(scene.supportRadius_m()),
      spacing_(scene.fluid.spacing_m),
      volume_(volume_m3) {}

double RestLattice::behind(const std::array<double, 3>& distances, int walls) const {
  const int reach = static_cast<int>(h_ / spacing_) + 1;
  const auto offset = [&](int axis, int k) {
    return axis < walls ? distances[std::size_t(axis)] + (k + 0.5) * spacing_ : k * spacing_;
  };
  const auto first = [&](int axis) { return axis < walls ? 0 : -reach; };
  double sum = 0.0;
  for (int x = first(0); x <= reach; ++x) {
    for (int y = first(1); y <= reach; ++y) {
      for (int z = first(2); z <= reach; ++z) {
        const Vec3d ghost(offset(0, x), offset(1, y), offset(2, z));
        sum += kernelValue(kernel_, h_, ghost.norm());
      }
    }
  }
  return volume_ * sum;
}

}  // namespace ice_ice_baby
