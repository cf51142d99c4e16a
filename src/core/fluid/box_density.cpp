#include "fluid/box_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ice_ice_baby {

namespace {

constexpr int kNodes = 32;  ///< of the table, within the reach
constexpr int kPad = 4;     ///< nodes beyond either end, where the spline settles
constexpr int kFiner = 3;   ///< cells of the sum per node

/// Integrals of W* from the origin to every node.
class CornerSums {
 public:
  explicit CornerSums(const WallKernel& kernel)
      : node_m_(kernel.reach_m() / kNodes), sums_(std::size_t(kSize) * kSize * kSize, 0.0) {
    const double cell = node_m_ / kFiner;
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        for (int k = 0; k < kCells; ++k) {
          const double r =
              cell * std::sqrt((i + .5) * (i + .5) + (j + .5) * (j + .5) + (k + .5) * (k + .5));
          if (r < kernel.reach_m()) {
            sum(i / kFiner + 1, j / kFiner + 1, k / kFiner + 1) +=
                kernel.value(r) * cell * cell * cell;
          }
        }
      }
    }
    accumulate();
  }

  /// @param x, y, z m, at nodes; negative ones have the opposite sign
  double operator()(double x, double y, double z) const {
    const double sign = std::copysign(1, x) * std::copysign(1, y) * std::copysign(1, z);
    const auto node = [&](double c) {
      return std::min(int(std::lround(std::abs(c) / node_m_)), kNodes);
    };
    return sign * sums_[place(node(x), node(y), node(z))];
  }

 private:
  static constexpr int kSize = kNodes + 1, kCells = kNodes * kFiner;

  static std::size_t place(int i, int j, int k) {
    return (std::size_t(i) * kSize + std::size_t(j)) * kSize + std::size_t(k);
  }
  double& sum(int i, int j, int k) { return sums_[place(i, j, k)]; }

  void accumulate() {
    for (int i = 1; i < kSize; ++i) {
      for (int j = 1; j < kSize; ++j) {
        for (int k = 1; k < kSize; ++k) {
          sum(i, j, k) += sum(i - 1, j, k) + sum(i, j - 1, k) + sum(i, j, k - 1) -
                          sum(i - 1, j - 1, k) - sum(i - 1, j, k - 1) - sum(i, j - 1, k - 1) +
                          sum(i - 1, j - 1, k - 1);
        }
      }
    }
  }

  double node_m_;
  std::vector<double> sums_;
};

/// One side of a box along an axis, as a term of the sum over corners.
template <class Real>
struct Term {
  Real coordinate;  ///< distance of the side from the point, m
  Real weight;
  Real slope;  ///< of the coordinate as the point moves along the axis, times the weight
};

template <class Real>
struct Terms {
  std::array<Term<Real>, 2> list;
  int count = 0;

  Terms(Real low, Real high, Real reach) {
    if (low <= -reach && high >= reach) {
      list[std::size_t(count++)] = {reach, 2, 0};
      return;
    }
    add(high, 1, reach);
    add(low, -1, reach);
  }

 private:
  void add(Real side, Real sign, Real reach) {
    const Real weight = side < 0 ? -sign : sign;
    const bool varies = std::abs(side) < reach;
    list[std::size_t(count++)] = {std::min(std::abs(side), reach), weight,
                                  varies ? -sign : Real(0)};
  }
};

}  // namespace

template <class Real>
BoxDensity<Real>::BoxDensity(const WallKernel& kernel) {
  const double step = kernel.reach_m() / kNodes;
  const typename SplineGrid<Real>::Axis axis{-kPad * step, step, kNodes + 1 + 2 * kPad};
  to_corner_ = SplineGrid<Real>({axis, axis, axis}, CornerSums(kernel));
  reach_ = static_cast<Real>(kernel.reach_m() + kPad * step);
}

template <class Real>
WallSample<Real> BoxDensity<Real>::at(const AlignedBox<Real>& box) const {
  WallSample<Real> sample;
  if ((box.low.array() >= box.high.array()).any()) return sample;
  if ((box.low.array() >= reach_).any() || (box.high.array() <= -reach_).any()) return sample;
  const std::array<Terms<Real>, 3> sides{Terms<Real>(box.low[0], box.high[0], reach_),
                                         Terms<Real>(box.low[1], box.high[1], reach_),
                                         Terms<Real>(box.low[2], box.high[2], reach_)};
  for (int i = 0; i < sides[0].count; ++i) {
    const Term<Real>& x = sides[0].list[std::size_t(i)];
    for (int j = 0; j < sides[1].count; ++j) {
      const Term<Real>& y = sides[1].list[std::size_t(j)];
      for (int k = 0; k < sides[2].count; ++k) {
        const Term<Real>& z = sides[2].list[std::size_t(k)];
        const auto corner = to_corner_.at({x.coordinate, y.coordinate, z.coordinate});
        sample.value += x.weight * y.weight * z.weight * corner.value;
        sample.gradient += Vec3<Real>(x.slope * y.weight * z.weight * corner.gradient.x(),
                                      x.weight * y.slope * z.weight * corner.gradient.y(),
                                      x.weight * y.weight * z.slope * corner.gradient.z());
      }
    }
  }
  return sample;
}

template class BoxDensity<float>;
template class BoxDensity<double>;

}  // namespace ice_ice_baby
