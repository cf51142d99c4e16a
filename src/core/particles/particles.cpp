#include "particles/particles.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ice_ice_baby {

template <class Real>
void Particles<Real>::reorder(const std::vector<Index>& order) {
  permute(position, order, scratch);
  permute(predicted, order, scratch);
  permute(velocity, order, scratch);
  permute(id, order, id_scratch);
}

template <class Real>
void Particles<Real>::add(const std::vector<Vec3d>& points, const std::vector<Vec3d>& velocities) {
  const std::size_t before = size(), after = before + points.size();
  position.resize(after);
  predicted.resize(after);
  velocity.resize(after);
  id.resize(after);
  for (std::size_t k = 0; k < points.size(); ++k) {
    position.set(before + k, points[k].cast<Real>());
    predicted.set(before + k, points[k].cast<Real>());
    velocity.set(before + k, velocities[k].cast<Real>());
    id[before + k] = next_id++;
  }
}

/// Radix sort from the lowest digit, with as many digits as the largest id has.
std::vector<Index> placesById(const std::vector<std::uint32_t>& id) {
  constexpr int kDigitBits = 11;
  constexpr std::uint32_t kDigits = 1u << kDigitBits;
  std::vector<Index> places(id.size()), sorted(id.size());
  std::iota(places.begin(), places.end(), Index(0));
  const std::uint64_t largest = id.empty() ? 0 : *std::max_element(id.begin(), id.end());
  for (int shift = 0; largest >> shift > 0; shift += kDigitBits) {
    const auto digit = [&](std::uint32_t one) { return (one >> shift) & (kDigits - 1); };
    std::array<Index, kDigits + 1> start{};
    for (const std::uint32_t one : id) ++start[digit(one) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const Index i : places) sorted[start[digit(id[i])]++] = i;
    places.swap(sorted);
  }
  return places;
}

template struct Particles<float>;
template struct Particles<double>;

}  // namespace ice_ice_baby
