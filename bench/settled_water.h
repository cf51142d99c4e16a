// Water at rest as the bare benchmarks see it: points and who is near whom, by no part of the
// solver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ice_ice_baby::bench {

/// Points of a shaken cubic lattice of spacing 1/2, so the support radius 1 holds about 30 of them
/// as in settled water. Sorted by cells of edge 1, which is how a solver would keep them.
struct SettledWater {
  /// @param count rounded to a whole cube
  explicit SettledWater(std::size_t count);

  std::size_t size() const { return x.size(); }

  std::vector<float> x, y, z;  ///< (n) in support radii
};

/// Per particle the others nearer than `reach`, in ascending order.
struct NearLists {
  /// Lists are filled up to a multiple of this with the particle itself, so that vectors need no
  /// remainder.
  static constexpr std::size_t kPadding = 16;

  NearLists(const SettledWater& water, float reach);

  double perParticle() const { return double(near) / double(begin.size() - 1); }
  double within() const { return double(padded.size()) / double(begin.size() - 1); }

  std::vector<std::size_t> begin;     ///< (n + 1) into padded
  std::vector<std::uint32_t> padded;  ///< every list and its padding
  std::size_t near = 0;               ///< entries that are not padding
};

}  // namespace ice_ice_baby::bench
