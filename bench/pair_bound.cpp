#include "pair_bound.h"

#include <algorithm>

// Vectors of unknown length cannot be members of a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pair_bound.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ice_ice_baby::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

/// x, y, z and the value of as many particles as a vector has lanes.
struct Points {
  V x, y, z, w;
};

struct Gathered {
  static HWY_INLINE Points load(const BareIteration& in, const std::uint32_t* j) {
    const D d;
    const hn::RebindToSigned<D> d_index;
    const auto index = hn::LoadU(d_index, reinterpret_cast<const std::int32_t*>(j));
    return {hn::GatherIndex(d, in.x, index), hn::GatherIndex(d, in.y, index),
            hn::GatherIndex(d, in.z, index), hn::GatherIndex(d, in.lambda, index)};
  }
};

#if HWY_TARGET == HWY_SCALAR

using Transposed = Gathered;

#else

/// Rows of the particles j[0], j[4], j[8] ..., one in each block of 16 bytes.
template <class DPart>
HWY_INLINE hn::Vec<DPart> everyFourth(DPart d, const float* rows, const std::uint32_t* j) {
  if constexpr (hn::MaxLanes(d) == 4) {
    return hn::LoadU(d, rows + 4 * std::size_t(*j));
  } else {
    const hn::Half<DPart> half;
    const auto low = everyFourth(half, rows, j);
    return hn::Combine(d, everyFourth(half, rows, j + hn::MaxLanes(half)), low);
  }
}

struct Transposed {
  static HWY_INLINE Points load(const BareIteration& in, const std::uint32_t* j) {
    const D d;
    const V row0 = everyFourth(d, in.rows, j), row1 = everyFourth(d, in.rows, j + 1);
    const V row2 = everyFourth(d, in.rows, j + 2), row3 = everyFourth(d, in.rows, j + 3);
    const V xy0 = hn::InterleaveLower(d, row0, row2), xy1 = hn::InterleaveLower(d, row1, row3);
    const V zw0 = hn::InterleaveUpper(d, row0, row2), zw1 = hn::InterleaveUpper(d, row1, row3);
    return {hn::InterleaveLower(d, xy0, xy1), hn::InterleaveUpper(d, xy0, xy1),
            hn::InterleaveLower(d, zw0, zw1), hn::InterleaveUpper(d, zw0, zw1)};
  }
};

#endif

/// One particle against a vector of neighbours: offsets, cubic spline W(q) / W(0) and slope, with
/// 0 for those that are too far or the particle itself.
struct Pairs {
  V x, y, z, w, square, weight, slope;
};

template <class Loader>
HWY_INLINE Pairs loadPairs(const BareIteration& in, std::size_t i, const std::uint32_t* j) {
  const D d;
  const Points other = Loader::load(in, j);
  Pairs p;
  p.x = hn::Sub(hn::Set(d, in.x[i]), other.x);
  p.y = hn::Sub(hn::Set(d, in.y[i]), other.y);
  p.z = hn::Sub(hn::Set(d, in.z[i]), other.z);
  p.w = other.w;
  p.square = hn::MulAdd(p.x, p.x, hn::MulAdd(p.y, p.y, hn::Mul(p.z, p.z)));
  const auto one = hn::Set(d, 1.0f), six = hn::Set(d, 6.0f);
  const auto near = hn::And(hn::Gt(p.square, hn::Zero(d)), hn::Lt(p.square, one));
  const V q = hn::Sqrt(p.square), u = hn::Sub(one, q), twice = hn::Mul(hn::Add(u, u), u);
  const auto inner = hn::Lt(q, hn::Set(d, 0.5f));
  const V weight = hn::NegMulAdd(hn::Mul(six, p.square), u, one);
  p.weight = hn::IfThenElseZero(near, hn::IfThenElse(inner, weight, hn::Mul(twice, u)));
  const V slope = hn::NegMulAdd(six, q, hn::Set(d, 4.0f));
  p.slope = hn::IfThenElseZero(near, hn::IfThenElse(inner, slope, hn::Div(twice, q)));
  return p;
}

HWY_INLINE float total(V v) { return hn::GetLane(hn::SumOfLanes(D(), v)); }

template <class Loader>
void lambdaPass(const BareIteration& in, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    V density = hn::Zero(D()), squares = density, x = density, y = density, z = density;
    for (std::size_t k = in.begin[i]; k < in.begin[i + 1]; k += kLanes) {
      const Pairs p = loadPairs<Loader>(in, i, in.padded + k);
      density = hn::Add(density, p.weight);
      squares = hn::MulAdd(hn::Mul(p.slope, p.slope), p.square, squares);
      x = hn::MulAdd(p.slope, p.x, x);
      y = hn::MulAdd(p.slope, p.y, y);
      z = hn::MulAdd(p.slope, p.z, z);
    }
    const float gx = total(x), gy = total(y), gz = total(z);
    const float gradients = total(squares) + gx * gx + gy * gy + gz * gz + 0.01f;
    in.lambda[i] = -std::max(0.32f * (1.0f + total(density)) - 1.0f, 0.0f) / gradients;
  }
}

template <class Loader>
void correctionPass(const BareIteration& in, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const V own = hn::Set(D(), in.lambda[i]);
    V x = hn::Zero(D()), y = x, z = x;
    for (std::size_t k = in.begin[i]; k < in.begin[i + 1]; k += kLanes) {
      const Pairs p = loadPairs<Loader>(in, i, in.padded + k);
      const V push = hn::Mul(p.slope, hn::Add(own, p.w));
      x = hn::MulAdd(push, p.x, x);
      y = hn::MulAdd(push, p.y, y);
      z = hn::MulAdd(push, p.z, z);
    }
    in.dx[i] = total(x);
    in.dy[i] = total(y);
    in.dz[i] = total(z);
  }
}

template <class Loader>
BarePasses passesOf() {
  return {&lambdaPass<Loader>, &correctionPass<Loader>};
}

BarePasses passesFor(Fetch fetch) {
  return fetch == Fetch::kRows ? passesOf<Transposed>() : passesOf<Gathered>();
}

}  // namespace HWY_NAMESPACE
}  // namespace ice_ice_baby::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace ice_ice_baby::bench {

HWY_EXPORT(passesFor);

BarePasses barePasses(Fetch fetch) { return HWY_DYNAMIC_DISPATCH(passesFor)(fetch); }

}  // namespace ice_ice_baby::bench

#endif  // HWY_ONCE
