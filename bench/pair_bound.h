// The least that an iteration of position based fluids can cost: its two passes over pairs of
// neighbours and nothing else. No walls, no collisions, no packing, no clocks; nothing of the
// solver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ice_ice_baby::bench {

/// Arrays of the two passes; lengths in support radii.
struct BareIteration {
  std::size_t size;             ///< n
  const std::size_t* begin;     ///< (n + 1) into padded
  const std::uint32_t* padded;  ///< neighbours, filled up to multiples of 16
  float* rows;                  ///< (n, 4) x, y, z and, for the correction pass, lambda
  const float *x, *y, *z;       ///< (n) the same points as arrays of their own
  float* lambda;                ///< (n)
  float *dx, *dy, *dz;          ///< (n)
};

/// A pass over particles first ... last - 1.
using BarePass = void (*)(const BareIteration&, std::size_t first, std::size_t last);

struct BarePasses {
  BarePass lambda;      ///< Eq. 2-5 without scales: density, squared gradients, lambda
  BarePass correction;  ///< Eq. 6 without scales
};

/// How a pass fetches its neighbours: rows of four loaded and transposed, or four arrays gathered.
enum class Fetch { kRows, kGather };

/// For this processor.
BarePasses barePasses(Fetch fetch);

}  // namespace ice_ice_baby::bench
