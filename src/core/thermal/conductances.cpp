#include "thermal/conductances.h"

#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

template <class Real>
Conductances<Real>::Conductances(const Colliders<Real>& colliders,
                                 const ThermalBoundaries<Real>& walls,
                                 const ConductionLattice& lattice)
    : mirrors_(colliders, walls, lattice),
      has_mirrors_(colliders.anyFlat()),
      kernel_(static_cast<Real>(lattice.support_m)),
      scale_(static_cast<Real>(lattice.length_m(lattice.support_m / 2))) {}

template <class Real>
void Conductances<Real>::begin(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                               const ThermalStep<Real>& step) {
  if (has_mirrors_) mirrors_.locate(x);
  presence_.resize(x.size());
  parallelFor(x.size(), [&](std::size_t i) {
    const bool absent = step.solid(i) || (step.steam && (*step.steam)[i]);
    presence_[i] = absent ? Real(0) : step.volume ? (*step.volume)[i] : Real(1);
  });
  rows_.pack(x, presence_);
  start_.resize(x.size());
  std::size_t links = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    start_[i] = links;
    links += neighbours.of(i).size();
  }
  if (links > links_.capacity()) links_.reserve(links + links / 4);
  links_.resize(links);
}

template <class Real>
void Conductances<Real>::measure(const VectorField<Real>& x, const Neighbours<Real>& neighbours,
                                 ParticleRange range, std::vector<Real>& total_m,
                                 VectorField<Real>& open_m2) {
  const PairInput<Real> pairs{neighbours, rows_.data(), nullptr, kernel_.h};
  pass_(pairs, {start_, links_, total_m, open_m2}, range);
  for (std::size_t i = range.first; i < range.last; ++i) {
    if (has_mirrors_ && presence_[i] > 0) total_m[i] += addImages(i, x, neighbours);
    total_m[i] *= scale_;
    open_m2.set(i, scale_ * open_m2.at(i));
  }
}

/// Adds the links to mirror images of neighbours to those of a particle; returns their sum.
template <class Real>
Real Conductances<Real>::addImages(std::size_t i, const VectorField<Real>& x,
                                   const Neighbours<Real>& neighbours) {
  const Vec3<Real> here = x.at(i);
  const auto faces = mirrors_.near(i, here);
  if (faces.count == 0) return 0;
  const Real unit = kernel_.slope(kernel_.h / 2) / (kernel_.h / 2);
  Real* link = links_.data() + start_[i];
  Real sum = 0;
  for (const Index j : neighbours.of(i)) {
    const Vec3<Real> there = x.at(j);
    const Real distance2 = (there - here).squaredNorm();
    Real images = 0;
    if (distance2 > 0 && distance2 < kernel_.h * kernel_.h) {
      mirrors_.forEachImage(faces, i, j, there, distance2, [&](Real image2) {
        const Real r = std::sqrt(image2);
        images += kernel_.slope(r) / (r * unit);
      });
    }
    images *= presence_[i] * presence_[j];
    *link++ += images;
    sum += images;
  }
  return sum;
}

template class Conductances<float>;
template class Conductances<double>;

}  // namespace ice_ice_baby
