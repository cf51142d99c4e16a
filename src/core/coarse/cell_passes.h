// Vectorised inner loops over the particles of one cell of the coarse grid.
//
// A particle touches the 27 nodes of the 3 x 3 x 3 cells around its own by tensor products of
// quadratic B-splines. Lengths along an axis are in units of the cell along it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Nodes that a particle touches, numbered (x * 3 + y) * 3 + z.
constexpr std::size_t kCellNodes = 27;
/// Different entries of the normal matrix of a cell; see CellPasses::normalMatrix.
constexpr std::size_t kCellPairs = 216;
/// Values that a cell deposits at each of its nodes.
constexpr std::size_t kDeposits = 4;

/// Particles sorted by cell; every array is followed by lanes of padding.
template <class Real>
struct CellParticles {
  std::array<std::vector<Real>, 3> place;  ///< in its cell, 0 ... 1
  std::array<std::vector<Real>, 3> step;   ///< displacement, cells
  std::array<std::vector<Real>, 3> free;   ///< (3 d / cell)^2, or 0 where a wall holds the particle
  std::vector<Real> volume;                ///< relative to water
  std::vector<Real> weight;                ///< volume squared, or 0: not in the normal matrix
  std::vector<Real> drift2;                ///< square of dt times speed, cells^2
  std::vector<Real> density;               ///< relative to water at rest

  void resize(std::size_t n);
  std::size_t bytes() const;
};

/// 3 d / cell along each axis for particle k, unless a wall holds it along that axis.
template <class Real>
Vec3<Real> scaleOf(const CellParticles<Real>& particles, std::size_t k) {
  return Vec3<Real>(particles.free[0][k], particles.free[1][k], particles.free[2][k]).cwiseSqrt();
}

/// Range of particles that lie in one cell.
struct CellRange {
  std::size_t first, count;
};

template <class Real>
struct CellPasses {
  /// Sums over the particles for each node a: v grad phi_a . s, and v phi_a times 1, drift2 and
  /// density.
  /// @param out (27, kDeposits)
  void (*deposit)(const CellParticles<Real>&, CellRange, Real* out);
  /// Sums v^2 grad phi_a . F grad phi_b, F = diag(free). An entry depends on the unordered pair of
  /// nodes along each axis alone: number (p_x * 6 + p_y) * 6 + p_z with p of kPairAlong.
  /// @param out (kCellPairs)
  void (*normalMatrix)(const CellParticles<Real>&, CellRange, Real* out);
  /// v sum_a mu_a grad phi_a to `slope`, and sum_a mu_a phi_a to `value`, of each particle.
  /// @param mu (27)
  void (*interpolate)(const CellParticles<Real>&, CellRange, const Real* mu,
                      std::array<Real*, 3> slope, Real* value);
};

/// Number of the unordered pair of two nodes along one axis.
constexpr int kPairAlong[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

/// Lanes of padding behind the arrays of CellParticles and of the output of interpolate.
constexpr std::size_t kCellPadding = 16;

template <class Real>
CellPasses<Real> cellPasses();

/// Quadratic B-splines of the three nodes along an axis, and their slopes.
template <class Real>
struct SplineAlong {
  std::array<Real, 3> value, slope;

  explicit SplineAlong(Real u)
      : value{(1 - u) * (1 - u) / 2, Real(0.75) - (u - Real(0.5)) * (u - Real(0.5)), u * u / 2},
        slope{u - 1, 1 - 2 * u, u} {}
};

/// Integrals of these splines over part of a cell.
template <class Real>
std::array<Real, 3> splineIntegrals(Real from, Real to) {
  const auto until = [](Real u) {
    const Real v = u - Real(0.5);
    return std::array<Real, 3>{-(1 - u) * (1 - u) * (1 - u) / 6, Real(0.75) * u - v * v * v / 3,
                               u * u * u / 6};
  };
  const auto low = until(from), high = until(to);
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

/// Splines of the nodes of a cell at one of its particles.
template <class Real>
struct SplineAt {
  SplineAlong<Real> x, y, z;

  SplineAt(const CellParticles<Real>& particles, std::size_t k)
      : x(particles.place[0][k]), y(particles.place[1][k]), z(particles.place[2][k]) {}

  Real value(std::size_t node) const {
    return x.value[node / 9] * y.value[node / 3 % 3] * z.value[node % 3];
  }
  Vec3<Real> slope(std::size_t node) const {
    const std::size_t i = node / 9, j = node / 3 % 3, k = node % 3;
    return {x.slope[i] * y.value[j] * z.value[k], x.value[i] * y.slope[j] * z.value[k],
            x.value[i] * y.value[j] * z.slope[k]};
  }
};

}  // namespace ice_ice_baby
