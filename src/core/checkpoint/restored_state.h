// Checks for state that was read from a checkpoint.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Far beyond the values of any run, and small enough that nothing computed from it overflows.
constexpr double kMaxStoredCoordinate_m = 1e12;
constexpr double kFastest_m_s = 1e8;

inline void requireValid(bool valid, const char* what) {
  if (!valid) throw InvalidInput(std::string("invalid checkpoint: ") + what);
}

inline bool within(double value, double low, double high) { return value >= low && value <= high; }

template <class Real>
bool allWithin(const std::vector<Real>& values, double low, double high) {
  return std::all_of(values.begin(), values.end(),
                     [&](Real value) { return within(double(value), low, high); });
}

/// Whether every index is below `count` and none occurs twice.
inline bool distinct(const std::vector<Index>& indices, std::size_t count) {
  std::vector<char> seen(count, false);
  return std::all_of(indices.begin(), indices.end(), [&](Index i) {
    const bool fresh = i < count && !seen[i];
    if (fresh) seen[i] = true;
    return fresh;
  });
}

inline bool belowOrNone(Index index, std::size_t count) { return index < count || index == kNone; }

template <class Matrix>
bool isRotation(const Matrix& rotation) {
  using Real = typename Matrix::Scalar;
  return rotation.isUnitary(Real(1e-3)) && rotation.determinant() > 0;
}

}  // namespace ice_ice_baby
