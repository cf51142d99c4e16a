// What is asked of state that was read from a checkpoint.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Far beyond what any run reaches, and so near that nothing worked out from it overflows a float.
constexpr double kFurthest_m = 1e12;
constexpr double kFastest_m_s = 1e8;

inline void requireSense(bool sense, const char* what) {
  if (!sense) throw InvalidInput(std::string("its state makes no sense: ") + what);
}

inline bool within(double value, double low, double high) { return value >= low && value <= high; }

template <class Real>
bool allWithin(const std::vector<Real>& values, double low, double high) {
  return std::all_of(values.begin(), values.end(),
                     [&](Real value) { return within(double(value), low, high); });
}

/// Whether every index is below `count` and none stands twice.
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
bool isRotation(const Matrix& turn) {
  using Real = typename Matrix::Scalar;
  return turn.isUnitary(Real(1e-3)) && turn.determinant() > 0;
}

}  // namespace ice_ice_baby
