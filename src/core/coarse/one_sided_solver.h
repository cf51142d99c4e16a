// Solves the complementarity problem of the coarse level: pressure pushes where water would
// overfill a node, and is zero elsewhere.
#pragma once

#include <vector>

#include "coarse/coarse_matrix.h"

namespace ice_ice_baby {

template <class Real>
class OneSidedSolver {
 public:
  /// mu <= 0 with A mu = b where mu < 0: conjugate gradients on the active nodes, of which those
  /// that would pull leave for good after each round. The result never adds energy, however
  /// inexact: it is scaled so that mu . b >= mu . A mu.
  /// @param b (active)
  /// @param mu at nodes; the guess, then the result
  void solve(const CoarseMatrix<Real>& matrix, const std::vector<Index>& active,
             const std::vector<Real>& b, NodeField<Real>& mu);

  std::size_t bytes() const;

 private:
  void conjugateGradients(const CoarseMatrix<Real>& matrix, const std::vector<Index>& active,
                          const std::vector<Real>& b, NodeField<Real>& mu);
  double dot(const std::vector<Real>& a, const std::vector<Real>& b);

  std::vector<char> off_;  ///< (active)
  std::vector<Real> residual_, scaled_, product_, direction_;
  NodeField<Real> search_;
  std::vector<double> partial_;
  int iterations_ = 0;  ///< of the present solve
};

}  // namespace ice_ice_baby
