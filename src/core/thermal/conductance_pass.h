// Vectorised loop over pairs that computes the conductances between neighbours.
#pragma once

#include "fluid/pair_passes.h"

namespace ice_ice_baby {

/// Output of the pass for each particle i and each neighbour j in its list.
template <class Real>
struct ConductanceSums {
  const std::vector<std::size_t>& start;  ///< (n) first link of a particle
  std::vector<Real>& links;  ///< a_i a_j s(r), s = (W'(r) / r) / (W'(h/2) / (h/2)), cubic spline
  std::vector<Real>& total;  ///< (n) sum over the neighbours
  VectorField<Real>& arms;   ///< (n) sum of links times x_j - x_i, m
};

/// Computes the links of a range of particles; a is the fourth column of the positions. Links of
/// pairs at distance 0 and beyond h are 0. A link is bit-identical from both sides.
template <class Real>
using ConductancePass = void (*)(const PairInput<Real>&, ConductanceSums<Real>, ParticleRange);

template <class Real>
ConductancePass<Real> conductancePass();

}  // namespace ice_ice_baby
