// Vectorised inner loops over pairs of neighbours.
//
// A pass sums over the neighbours of a particle, in the order of its list and independently of
// every other particle, so the result is bit-identical for any number of threads. The number of
// lanes depends on the processor, so different processors may differ in rounding.
#pragma once

#include <vector>

#include "ice_ice_baby/params.h"
#include "particles/neighbours.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Rows of four values: three coordinates of a particle and a fourth value, contiguous, so that a
/// neighbour costs one load instead of four gathers.
template <class Real>
class PackedXyzw {
 public:
  void pack(const VectorField<Real>& field);
  void pack(const VectorField<Real>& field, const std::vector<Real>& fourth);

  const Real* data() const { return rows_.data(); }
  std::size_t bytes() const { return rows_.capacity() * sizeof(Real); }

 private:
  std::vector<Real> rows_;  ///< (n, 4)
};

/// Particles first ... last - 1.
struct ParticleRange {
  std::size_t first, last;
};

/// Input of every pass.
template <class Real>
struct PairInput {
  const Neighbours<Real>& neighbours;
  const Real* positions;  ///< (n, 4) packed, m
  const Real* values;     ///< (n, 4) packed, the quantity that the pass sums
  Real support;           ///< h, m
  /// (n) volume relative to water; null if all particles are water.
  const Real* relative_volumes = nullptr;
  Real shear = 0;  ///< of a mixture: see mixturePairPasses
};

/// Fourth value of rigid ice in a mixture. Two such particles exert no viscosity on each other.
constexpr float kRigidGrip = 1e30f;

/// Sums of Eq. 2 and 4 over the neighbours of each particle with normalised kernels:
/// w = W(r) / W(0) and s = (W'(r) / r) / (W'(h/2) / (h/2)).
template <class Real>
struct ConstraintSums {
  std::vector<Real>& density;    ///< (n) sum w
  std::vector<Real>& squares;    ///< (n) sum (s r / h)^2
  VectorField<Real>& gradients;  ///< (n) sum s (x_i - x_j)
};

/// The passes for one kernel pair on this processor. Pairs beyond h contribute nothing. Pairs at
/// distance 0, which have no direction, contribute nothing to a gradient.
template <class Real>
struct PairPasses {
  void (*sumConstraint)(const PairInput<Real>&, ConstraintSums<Real>, ParticleRange);
  /// Sum (lambda_i + lambda_j) s (x_i - x_j), lambda in the fourth column of the positions.
  void (*sumCorrections)(const PairInput<Real>&, VectorField<Real>&, ParticleRange);
  /// Adds factor * sum (v_j - v_i) w of the cubic spline, v in the values.
  void (*addDifferences)(const PairInput<Real>&, Real factor, VectorField<Real>&, ParticleRange);
};

template <class Real>
PairPasses<Real> pairPasses(KernelPair kernel);

/// The same for particles of different volume, such as water, ice and steam:
/// - sumConstraint counts neighbour j v_j times, the relative volume v in the fourth column of the
///   positions;
/// - sumCorrections sums (lambda_i v_j + lambda_j v_i) s (x_i - x_j), the gradient of that;
/// - addDifferences weights a pair with the smaller of the two fourth columns of the values, unless
///   both are kRigidGrip. The part above `shear` acts only along the line between the two, which
///   conserves angular momentum.
template <class Real>
PairPasses<Real> mixturePairPasses(KernelPair kernel);

}  // namespace ice_ice_baby
