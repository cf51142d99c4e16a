#include "ice_ice_baby/heat_links.h"

#include <cmath>

namespace ice_ice_baby {

template <class Real>
HeatLinks<Real>::HeatLinks(const Colliders<Real>& colliders, const HeatWalls<Real>& walls,
                           const HeatLattice& lattice)
    : mirrors_(colliders, walls, lattice),
      has_mirrors_(!colliders.containers.empty() || !colliders.planes.empty()),
      support_(static_cast<Real>(lattice.support_m)),
      scale_(static_cast<Real>(lattice.length_m(lattice.support_m / 2) / 3)) {}

template <class Real>
Real HeatLinks<Real>::length(Real distance2) const {
  if (!(distance2 < support_ * support_)) return 0;
  const Real q = std::sqrt(distance2) / support_;
  if (q <= Real(0.5)) return scale_ * (12 - 18 * q);
  return scale_ * 6 * (1 - q) * (1 - q) / q;
}

template <class Real>
void HeatLinks<Real>::begin(const VectorField<Real>& x, const Neighbours<Real>& neighbours) {
  if (has_mirrors_) mirrors_.locate(x);
  start_.resize(x.size());
  std::size_t links = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    start_[i] = links;
    links += neighbours.of(i).size();
  }
  if (links > lengths_.capacity()) lengths_.reserve(links + links / 4);
  lengths_.resize(links);
}

template <class Real>
typename HeatLinks<Real>::Sum HeatLinks<Real>::measure(std::size_t i, const VectorField<Real>& x,
                                                       const Neighbours<Real>& neighbours,
                                                       const HeatStep<Real>& step) {
  using Faces = typename HeatMirrors<Real>::Faces;
  const std::uint8_t* steam = step.steam ? step.steam->data() : nullptr;
  const Real* volume = step.volume ? step.volume->data() : nullptr;
  const Vec3<Real> here = x.at(i);
  const Faces faces = has_mirrors_ ? mirrors_.near(i, here) : Faces{};
  const bool alone = steam && steam[i];
  Real* out = lengths_.data() + start_[i];
  Sum sum;
  for (const Index j : neighbours.of(i)) {
    const Vec3<Real> there = x.at(j);
    const Vec3<Real> arm = there - here;
    const Real distance2 = arm.squaredNorm();
    Real link = 0;
    if (!alone && distance2 > 0 && !(steam && steam[j])) {
      const Real both = volume ? volume[i] * volume[j] : Real(1);
      link = both * length(distance2);
      sum.open_m2 += link * arm;
      if (faces.count > 0) {
        mirrors_.forEachImage(faces, i, j, there, distance2,
                              [&](Real image2) { link += both * length(image2); });
      }
    }
    sum.length_m += link;
    *out++ = link;
  }
  return sum;
}

template class HeatLinks<float>;
template class HeatLinks<double>;

}  // namespace ice_ice_baby
