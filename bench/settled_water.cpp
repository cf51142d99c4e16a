#include "settled_water.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace ice_ice_baby::bench {

namespace {

/// Cells of edge 1 in a cube of `side` of them, x first.
std::uint32_t cellOf(float x, float y, float z, std::uint32_t side) {
  const auto clamped = [&](float v) {
    return std::min(side - 1, static_cast<std::uint32_t>(std::max(0.0f, v)));
  };
  return (clamped(z) * side + clamped(y)) * side + clamped(x);
}

std::uint32_t sideOf(const SettledWater& water) {
  return 1 + static_cast<std::uint32_t>(*std::max_element(water.x.begin(), water.x.end()));
}

std::vector<float> permuted(const std::vector<float>& values,
                            const std::vector<std::uint32_t>& order) {
  std::vector<float> sorted(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
  return sorted;
}

/// First particle of each cell, and an end mark; the particles are sorted by cell.
std::vector<std::uint32_t> cellStarts(const SettledWater& water, std::uint32_t side) {
  std::vector<std::uint32_t> starts(std::size_t(side) * side * side + 1, 0);
  for (std::size_t i = 0; i < water.size(); ++i) {
    ++starts[cellOf(water.x[i], water.y[i], water.z[i], side) + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

}  // namespace

SettledWater::SettledWater(std::size_t count) {
  const int edge = static_cast<int>(std::lround(std::cbrt(double(count))));
  constexpr float kShake = 0.3f;  // of the spacing: the lattice's shells of neighbours are gone
  std::mt19937 random(1);
  const auto shaken = [&](int k) {
    return 0.5f * (float(k) + 0.5f + kShake * (float(random() >> 8) * 0x1p-23f - 1.0f));
  };
  for (int k = 0; k < edge * edge * edge; ++k) {
    x.push_back(shaken(k % edge));
    y.push_back(shaken(k / edge % edge));
    z.push_back(shaken(k / edge / edge));
  }
  const std::uint32_t side = sideOf(*this);
  std::vector<std::uint32_t> order(size()), cell(size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = 0; i < size(); ++i) cell[i] = cellOf(x[i], y[i], z[i], side);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cell[a] < cell[b]; });
  x = permuted(x, order);
  y = permuted(y, order);
  z = permuted(z, order);
}

NearLists::NearLists(const SettledWater& water, float reach) {
  const std::uint32_t side = sideOf(water);
  const std::vector<std::uint32_t> starts = cellStarts(water, side);
  const int cells = static_cast<int>(std::ceil(reach));
  begin.push_back(0);
  for (std::uint32_t i = 0; i < water.size(); ++i) {
    const int cx = int(water.x[i]), cy = int(water.y[i]), cz = int(water.z[i]);
    const int low = std::max(0, cx - cells), high = std::min(int(side) - 1, cx + cells);
    for (int z = std::max(0, cz - cells); z <= std::min(int(side) - 1, cz + cells); ++z) {
      for (int y = std::max(0, cy - cells); y <= std::min(int(side) - 1, cy + cells); ++y) {
        const std::size_t row = (std::size_t(z) * side + std::size_t(y)) * side;
        for (auto j = starts[row + std::size_t(low)]; j < starts[row + std::size_t(high) + 1];
             ++j) {
          const float dx = water.x[j] - water.x[i];
          const float dy = water.y[j] - water.y[i];
          const float dz = water.z[j] - water.z[i];
          if (j != i && dx * dx + dy * dy + dz * dz < reach * reach) padded.push_back(j);
        }
      }
    }
    near += padded.size() - begin.back();
    while (padded.size() % kPadding != 0) padded.push_back(i);
    begin.push_back(padded.size());
  }
}

}  // namespace ice_ice_baby::bench
