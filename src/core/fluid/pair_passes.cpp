#include "fluid/pair_passes.h"

#include "base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fluid/pair_passes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/packed_load-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby {
namespace HWY_NAMESPACE {

/// One particle with one vector of neighbours.
template <class D>
struct Pairs {
  hn::Vec<D> x, y, z;  ///< x_i - x_j, m
  hn::Vec<D> fourth;   ///< of the neighbours
  hn::Vec<D> square;   ///< q^2 = (r / h)^2
  hn::Mask<D> near;    ///< in the list and q < 1
  hn::Mask<D> within;  ///< and 0 < q
};

/// Lanes of a vector that hold neighbours.
template <class D>
struct Some {
  hn::Mask<D> mask;
  HWY_INLINE hn::Mask<D> operator()(hn::Mask<D> other) const { return hn::And(mask, other); }
};
struct All {
  template <class Mask>
  HWY_INLINE Mask operator()(Mask other) const {
    return other;
  }
};

/// Loads the neighbours at j into the active lanes.
template <class D, class Real, class Kept>
HWY_INLINE Pairs<D> loadPairs(D d, const Columns<D>& own, Real inverse_h2, const Real* positions,
                              const Index* j, Kept kept) {
  const Columns<D> other = loadRows(d, positions, j);
  Pairs<D> pairs;
  pairs.x = hn::Sub(own.x, other.x);
  pairs.y = hn::Sub(own.y, other.y);
  pairs.z = hn::Sub(own.z, other.z);
  pairs.fourth = other.w;
  const auto r2 =
      hn::MulAdd(pairs.x, pairs.x, hn::MulAdd(pairs.y, pairs.y, hn::Mul(pairs.z, pairs.z)));
  pairs.square = hn::Mul(r2, hn::Set(d, inverse_h2));
  pairs.near = kept(hn::Lt(pairs.square, hn::Set(d, Real(1))));
  pairs.within = hn::And(pairs.near, hn::Gt(pairs.square, hn::Zero(d)));
  return pairs;
}

/// Calls visit(j, kept) for vectors of neighbours at j. Only the last vector masks lanes.
template <class D, class List, class Visit>
HWY_INLINE void forEachVector(D d, List list, const Visit& visit) {
  for (; list.size() >= hn::MaxLanes(d); list.first += hn::MaxLanes(d)) visit(list.first, All());
  if (list.size() > 0) visit(list.first, Some<D>{hn::FirstN(d, list.size())});
}

/// One particle broadcast to every lane.
template <class D, class Real>
HWY_INLINE Columns<D> spread(D d, const Real* rows, std::size_t i) {
  const Real* row = rows + 4 * i;
  return {hn::Set(d, row[0]), hn::Set(d, row[1]), hn::Set(d, row[2]), hn::Set(d, row[3])};
}

template <class D>
HWY_INLINE hn::TFromD<D> total(D d, hn::Vec<D> v) {
  return hn::GetLane(hn::SumOfLanes(d, v));
}

/// W(q) / W(0) of the cubic spline: 1 - 6 q^2 (1 - q) for q < 1/2, and 2 (1 - q)^3 beyond.
template <class D>
HWY_INLINE hn::Vec<D> cubicWeight(D d, hn::Vec<D> q, hn::Vec<D> square) {
  using Real = hn::TFromD<D>;
  const auto one = hn::Set(d, Real(1));
  const auto u = hn::Sub(one, q);
  const auto inner = hn::NegMulAdd(hn::Mul(hn::Set(d, Real(6)), square), u, one);
  const auto outer = hn::Mul(hn::Add(u, u), hn::Mul(u, u));
  return hn::IfThenElse(hn::Lt(q, hn::Set(d, Real(0.5))), inner, outer);
}

/// Beyond q = 1/2 the slopes of both gradient kernels have the same shape.
template <class D>
HWY_INLINE hn::Vec<D> outerSlope(D d, hn::Vec<D> q) {
  const auto u = hn::Sub(hn::Set(d, hn::TFromD<D>(1)), q);
  return hn::Div(hn::Mul(hn::Add(u, u), u), q);
}

/// Normalised kernels in units of h; see ConstraintSums.
struct CubicShape {
  template <class D>
  static HWY_INLINE hn::Vec<D> weight(D d, hn::Vec<D> q, hn::Vec<D> square) {
    return cubicWeight(d, q, square);
  }
  template <class D>
  static HWY_INLINE hn::Vec<D> slope(D d, hn::Vec<D> q) {
    using Real = hn::TFromD<D>;
    const auto inner = hn::NegMulAdd(hn::Set(d, Real(6)), q, hn::Set(d, Real(4)));
    return hn::IfThenElse(hn::Lt(q, hn::Set(d, Real(0.5))), inner, outerSlope(d, q));
  }
};

struct Poly6SpikyShape {
  template <class D>
  static HWY_INLINE hn::Vec<D> weight(D d, hn::Vec<D>, hn::Vec<D> square) {
    const auto u = hn::Sub(hn::Set(d, hn::TFromD<D>(1)), square);
    return hn::Mul(u, hn::Mul(u, u));
  }
  template <class D>
  static HWY_INLINE hn::Vec<D> slope(D d, hn::Vec<D> q) {
    return outerSlope(d, q);
  }
};

/// All particles are water, so there are no weights.
struct Water {
  template <class Vec>
  static HWY_INLINE Vec scaled(Vec weight, Vec) {
    return weight;
  }
  template <class D, class Real>
  static HWY_INLINE hn::Vec<D> multiplier(D, hn::Vec<D> own, hn::Vec<D> other,
                                          const PairInput<Real>&, std::size_t, const Index*) {
    return hn::Add(own, other);
  }
  template <class D, class Real>
  static HWY_INLINE Columns<D> difference(D, const Columns<D>& own, const Columns<D>& other,
                                          const Pairs<D>&, const PairInput<Real>&) {
    return {hn::Sub(other.x, own.x), hn::Sub(other.y, own.y), hn::Sub(other.z, own.z), own.w};
  }
};

/// Water, ice and steam: see mixturePairPasses.
struct Mixed {
  template <class Vec>
  static HWY_INLINE Vec scaled(Vec weight, Vec volume) {
    return hn::Mul(weight, volume);
  }
  template <class D, class Real>
  static HWY_INLINE hn::Vec<D> multiplier(D d, hn::Vec<D> own, hn::Vec<D> other,
                                          const PairInput<Real>& in, std::size_t i,
                                          const Index* j) {
    const auto own_volume = hn::Set(d, in.relative_volumes[i]);
    return hn::MulAdd(own, loadEach(d, in.relative_volumes, j), hn::Mul(other, own_volume));
  }
  template <class D, class Real>
  static HWY_INLINE Columns<D> difference(D d, const Columns<D>& own, const Columns<D>& other,
                                          const Pairs<D>& pairs, const PairInput<Real>& in) {
    const auto lesser = hn::Min(own.w, other.w);
    const auto moves = hn::Lt(lesser, hn::Set(d, Real(kRigidGrip)));
    const auto shear = hn::Set(d, in.shear);
    const auto whole = hn::IfThenElseZero(moves, hn::Min(lesser, shear));
    const auto beyond = hn::IfThenElseZero(moves, hn::Max(hn::Sub(lesser, shear), hn::Zero(d)));
    const auto x = hn::Sub(other.x, own.x), y = hn::Sub(other.y, own.y),
               z = hn::Sub(other.z, own.z);
    const auto closing = hn::MulAdd(x, pairs.x, hn::MulAdd(y, pairs.y, hn::Mul(z, pairs.z)));
    const auto r2 = hn::Mul(pairs.square, hn::Set(d, in.support * in.support));
    const auto along = hn::IfThenElseZero(pairs.within, hn::Div(hn::Mul(beyond, closing), r2));
    return {hn::MulAdd(whole, x, hn::Mul(along, pairs.x)),
            hn::MulAdd(whole, y, hn::Mul(along, pairs.y)),
            hn::MulAdd(whole, z, hn::Mul(along, pairs.z)), lesser};
  }
};

template <class Shape, class Kind, class Real>
void sumConstraint(const PairInput<Real>& in, ConstraintSums<Real> out, ParticleRange range) {
  const Lanes<Real> d;
  const Real inverse_h2 = 1 / (in.support * in.support);
  for (std::size_t i = range.first; i < range.last; ++i) {
    const auto own = spread(d, in.positions, i);
    auto density = hn::Zero(d), squares = density, x = density, y = density, z = density;
    forEachVector(d, in.neighbours.of(i), [&](const Index* j, auto kept) HWY_ATTR {
      const auto pairs = loadPairs(d, own, inverse_h2, in.positions, j, kept);
      const auto q = hn::Sqrt(pairs.square);
      const auto weight = Kind::scaled(Shape::weight(d, q, pairs.square), pairs.fourth);
      const auto slope =
          hn::IfThenElseZero(pairs.within, Kind::scaled(Shape::slope(d, q), pairs.fourth));
      density = hn::Add(density, hn::IfThenElseZero(pairs.within, weight));
      squares = hn::MulAdd(hn::Mul(slope, slope), pairs.square, squares);
      x = hn::MulAdd(slope, pairs.x, x);
      y = hn::MulAdd(slope, pairs.y, y);
      z = hn::MulAdd(slope, pairs.z, z);
    });
    out.density[i] = total(d, density);
    out.squares[i] = total(d, squares);
    out.gradients.x[i] = total(d, x);
    out.gradients.y[i] = total(d, y);
    out.gradients.z[i] = total(d, z);
  }
}

template <class Shape, class Kind, class Real>
void sumCorrections(const PairInput<Real>& in, VectorField<Real>& out, ParticleRange range) {
  const Lanes<Real> d;
  const Real inverse_h2 = 1 / (in.support * in.support);
  for (std::size_t i = range.first; i < range.last; ++i) {
    const auto own = spread(d, in.positions, i);
    auto x = hn::Zero(d), y = x, z = x;
    forEachVector(d, in.neighbours.of(i), [&](const Index* j, auto kept) HWY_ATTR {
      const auto pairs = loadPairs(d, own, inverse_h2, in.positions, j, kept);
      const auto slope = Shape::slope(d, hn::Sqrt(pairs.square));
      const auto both = Kind::multiplier(d, own.w, pairs.fourth, in, i, j);
      const auto push = hn::IfThenElseZero(pairs.within, hn::Mul(both, slope));
      x = hn::MulAdd(push, pairs.x, x);
      y = hn::MulAdd(push, pairs.y, y);
      z = hn::MulAdd(push, pairs.z, z);
    });
    out.x[i] = total(d, x);
    out.y[i] = total(d, y);
    out.z[i] = total(d, z);
  }
}

template <class Kind, class Real>
void addDifferences(const PairInput<Real>& in, Real factor, VectorField<Real>& out,
                    ParticleRange range) {
  const Lanes<Real> d;
  const Real inverse_h2 = 1 / (in.support * in.support);
  for (std::size_t i = range.first; i < range.last; ++i) {
    const auto own = spread(d, in.positions, i);
    const auto own_value = spread(d, in.values, i);
    auto x = hn::Zero(d), y = x, z = x;
    forEachVector(d, in.neighbours.of(i), [&](const Index* j, auto kept) HWY_ATTR {
      const auto pairs = loadPairs(d, own, inverse_h2, in.positions, j, kept);
      const auto value = loadRows(d, in.values, j);
      const auto weight =
          hn::IfThenElseZero(pairs.near, cubicWeight(d, hn::Sqrt(pairs.square), pairs.square));
      const auto taken = Kind::difference(d, own_value, value, pairs, in);
      x = hn::MulAdd(weight, taken.x, x);
      y = hn::MulAdd(weight, taken.y, y);
      z = hn::MulAdd(weight, taken.z, z);
    });
    out.x[i] += factor * total(d, x);
    out.y[i] += factor * total(d, y);
    out.z[i] += factor * total(d, z);
  }
}

template <class Shape, class Kind, class Real>
PairPasses<Real> passesOf() {
  return {&sumConstraint<Shape, Kind, Real>, &sumCorrections<Shape, Kind, Real>,
          &addDifferences<Kind, Real>};
}

template <class Kind, class Real>
PairPasses<Real> passesFor(KernelPair kernel) {
  if (kernel == KernelPair::kCubic) return passesOf<CubicShape, Kind, Real>();
  return passesOf<Poly6SpikyShape, Kind, Real>();
}

PairPasses<float> floatPasses(KernelPair kernel) { return passesFor<Water, float>(kernel); }
PairPasses<double> doublePasses(KernelPair kernel) { return passesFor<Water, double>(kernel); }
PairPasses<float> mixedFloatPasses(KernelPair kernel) { return passesFor<Mixed, float>(kernel); }
PairPasses<double> mixedDoublePasses(KernelPair kernel) { return passesFor<Mixed, double>(kernel); }

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby {

HWY_EXPORT(floatPasses);
HWY_EXPORT(doublePasses);
HWY_EXPORT(mixedFloatPasses);
HWY_EXPORT(mixedDoublePasses);

template <>
PairPasses<float> pairPasses(KernelPair kernel) {
  return HWY_DYNAMIC_DISPATCH(floatPasses)(kernel);
}
template <>
PairPasses<double> pairPasses(KernelPair kernel) {
  return HWY_DYNAMIC_DISPATCH(doublePasses)(kernel);
}
template <>
PairPasses<float> mixturePairPasses(KernelPair kernel) {
  return HWY_DYNAMIC_DISPATCH(mixedFloatPasses)(kernel);
}
template <>
PairPasses<double> mixturePairPasses(KernelPair kernel) {
  return HWY_DYNAMIC_DISPATCH(mixedDoublePasses)(kernel);
}

}  // namespace ice_ice_baby

#endif  // HWY_ONCE
