#include "fluid/overlap_density.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace ice_ice_baby {

namespace {

constexpr int kDistances = 32, kAngles = 32, kDirections = 96;

/// Integral of W* over the directions along the edge, then over the distance from r on: what a
/// sector of the plane across the edge adds, per angle.
class SectorTable {
 public:
  explicit SectorTable(const WallKernel& kernel) : reach_m_(kernel.reach_m()) {
    // A half space is a sum of sectors: T(s) = 2 * integral of beyond(s / cos) over 0 ... pi / 2.
    // Along the edge: beyond(R) = integral of g(R / cos e) cos e de, over the elevation e.
    for (int k = 0; k < kSize; ++k) {
      const double r = reach_m_ * k / (kSize - 1);
      double sum = 0.0;
      for (int e = 0; e < kDirections; ++e) {
        const double cosine = std::cos((e + 0.5) * M_PI / 2 / kDirections);
        sum += 2 * kernel.beyond(r / cosine) * cosine * M_PI / 2 / kDirections;
      }
      values_.push_back(sum);
    }
    values_.push_back(0.0);
  }

  double at(double r) const {
    const double place = r / reach_m_ * (kSize - 1);
    if (!(place < kSize - 1)) return 0.0;
    const auto k = static_cast<std::size_t>(place);
    return values_[k] + (place - double(k)) * (values_[k + 1] - values_[k]);
  }

 private:
  static constexpr int kSize = 1025;
  double reach_m_;
  std::vector<double> values_;
};

double overlap(const SectorTable& sectors, double a, double b, double angle) {
  // Directions that enter both: within pi / 2 of either inward normal, at 0 and at `angle`.
  const double from = angle - M_PI / 2, to = M_PI / 2;
  double sum = 0.0;
  for (int k = 0; k < kDirections; ++k) {
    const double theta = from + (to - from) * (k + 0.5) / kDirections;
    const double into_a = std::cos(theta), into_b = std::cos(theta - angle);
    sum += sectors.at(std::max(a / std::max(into_a, 1e-9), b / std::max(into_b, 1e-9)));
  }
  return std::max(sum * (to - from) / kDirections, 0.0);
}

}  // namespace

/// Tabulated over the angle, in which it is smooth. Continued to negative distances without a kink.
template <class Real>
OverlapDensity<Real>::OverlapDensity(const WallKernel& kernel) {
  const SectorTable sectors(kernel);
  const double step = kernel.reach_m() / kDistances, turn = M_PI / kAngles;
  const typename SplineGrid<Real>::Axis distance{-2 * step, step, kDistances + 5};
  const typename SplineGrid<Real>::Axis angle{-2 * turn, turn, kAngles + 5};
  const std::function<double(double, double, double)> of = [&](double a, double b, double theta) {
    if (a < 0) return 2 * of(0, b, theta) - of(-a, b, theta);
    if (b < 0) return 2 * of(a, 0, theta) - of(a, -b, theta);
    return overlap(sectors, a, b, std::min(std::abs(theta), M_PI));
  };
  shared_ = SplineGrid<Real>({distance, distance, angle}, of);
}

template <class Real>
typename OverlapDensity<Real>::Sample OverlapDensity<Real>::at(Real a, Real b, Real cosine) const {
  const Real c = std::clamp(cosine, Real(-1), Real(1));
  const Real sine = std::sqrt(std::max(1 - c * c, Real(1e-8)));
  const auto sample = shared_.at({std::max(a, Real(0)), std::max(b, Real(0)), std::acos(c)});
  return {sample.value, a > 0 ? sample.gradient[0] : 0, b > 0 ? sample.gradient[1] : 0,
          -sample.gradient[2] / sine};
}

template class OverlapDensity<float>;
template class OverlapDensity<double>;

}  // namespace ice_ice_baby
