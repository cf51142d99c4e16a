// A smooth function on a regular grid in three dimensions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Quadratic B-spline through given values. Its gradient is exactly that of its value and is
/// continuous, so a force that follows from it conserves energy. Constant along an axis from half a
/// step inside the first and the last node on. The value has a step there unless the function is
/// constant at that end, so callers add nodes beyond what they use.
template <class Real>
class SplineGrid {
 public:
  struct Sample {
    Real value;
    Vec3<Real> gradient;  ///< 1 / unit of the axis
  };
  struct Axis {
    double first;  ///< coordinate of the first node
    double step;
    int nodes;
  };

  SplineGrid() = default;

  /// @param function value at (x, y, z)
  template <class Function>
  SplineGrid(const std::array<Axis, 3>& axes, const Function& function) : axes_(axes) {
    std::vector<double> values;
    for (int i = 0; i < axes[0].nodes; ++i) {
      for (int j = 0; j < axes[1].nodes; ++j) {
        for (int k = 0; k < axes[2].nodes; ++k) {
          values.push_back(function(place(0, i), place(1, j), place(2, k)));
        }
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) interpolate(values, axis);
    coefficients_.assign(values.begin(), values.end());
  }

  Sample at(const Vec3<Real>& point) const {
    const std::array<Weights, 3> w{weights(0, point[0]), weights(1, point[1]),
                                   weights(2, point[2])};
    Sample sample{0, Vec3<Real>::Zero()};
    for (int i = 0; i < w[0].count; ++i) {
      for (int j = 0; j < w[1].count; ++j) {
        const std::size_t row = (std::size_t(w[0].first + i) * std::size_t(axes_[1].nodes) +
                                 std::size_t(w[1].first + j)) *
                                    std::size_t(axes_[2].nodes) +
                                std::size_t(w[2].first);
        Real line = 0, slope = 0;
        for (int k = 0; k < w[2].count; ++k) {
          const Real c = coefficients_[row + std::size_t(k)];
          line += w[2].of[k] * c;
          slope += w[2].slope[k] * c;
        }
        sample.value += w[0].of[i] * w[1].of[j] * line;
        sample.gradient +=
            Vec3<Real>(w[0].slope[i] * w[1].of[j] * line, w[0].of[i] * w[1].slope[j] * line,
                       w[0].of[i] * w[1].of[j] * slope);
      }
    }
    return sample;
  }

  std::size_t bytes() const { return coefficients_.capacity() * sizeof(Real); }

 private:
  /// Of the nodes near a coordinate along one axis; a single one where the function is constant.
  struct Weights {
    int first, count;
    Real of[3], slope[3];
  };

  double place(std::size_t axis, int node) const {
    return axes_[axis].first + node * axes_[axis].step;
  }

  Weights weights(std::size_t axis, Real coordinate) const {
    const Axis& a = axes_[axis];
    const Real per = static_cast<Real>(1.0 / a.step);
    const Real u = (coordinate - static_cast<Real>(a.first)) * per;
    if (!(u > Real(0.5))) return {0, 1, {1, 0, 0}, {0, 0, 0}};
    if (u >= static_cast<Real>(a.nodes) - Real(1.5)) return {a.nodes - 1, 1, {1, 0, 0}, {0, 0, 0}};
    const int node = static_cast<int>(u + Real(0.5));
    const Real t = u - static_cast<Real>(node);
    const Real low = Real(0.5) - t, high = Real(0.5) + t;
    return {node - 1,
            3,
            {low * low / 2, Real(0.75) - t * t, high * high / 2},
            {-low * per, -2 * t * per, high * per}};
  }

  /// Replaces values along an axis by the coefficients of the spline through them.
  void interpolate(std::vector<double>& values, std::size_t axis) const {
    std::size_t stride = 1;
    for (std::size_t k = axis + 1; k < 3; ++k) stride *= std::size_t(axes_[k].nodes);
    const auto n = std::size_t(axes_[axis].nodes);
    std::vector<double> pivot(n);
    for (std::size_t line = 0; line < values.size() / n; ++line) {
      double* v = &values[line / stride * stride * n + line % stride];
      // (c[k-1] + 6 c[k] + c[k+1]) / 8 = v[k]; the ends keep their value
      pivot[0] = 0.0;
      for (std::size_t k = 1; k + 1 < n; ++k) {
        pivot[k] = 1.0 / (6.0 - pivot[k - 1]);
        v[k * stride] = (8.0 * v[k * stride] - v[(k - 1) * stride]) * pivot[k];
      }
      for (std::size_t k = n - 2; k > 0; --k) v[k * stride] -= pivot[k] * v[(k + 1) * stride];
    }
  }

  std::array<Axis, 3> axes_{};
  std::vector<Real> coefficients_;
};

}  // namespace ice_ice_baby
