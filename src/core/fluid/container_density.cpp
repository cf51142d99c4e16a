#include "fluid/container_density.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr int kEdgeSize = 64;
constexpr int kCornerSize = 32;

}  // namespace

template <class Real>
ContainerDensity<Real>::ContainerDensity(const RestLattice& lattice,
                                         const DistanceTable<Real>& flat, Real radius_m)
    : flat_(flat),
      support_m_(lattice.support_m()),
      radius_(radius_m),
      edge_(edge(lattice)),
      corner_(corner(lattice)) {}

template <class Real>
WallSample<Real> ContainerDensity<Real>::at(const Vec3<Real>& point,
                                            const std::optional<Rim<Real>>& rim,
                                            const NearSurfaces<Real>& near) const {
  if (near.count == 0) return {};
  return rim ? nearRim(*rim, point, near) : sumOf(near);
}

template <class Real>
std::pair<Real, Real> ContainerDensity<Real>::shareBelow(const Rim<Real>& rim) const {
  const auto [half, slope] = flat_.at(std::abs(rim.above));
  const Real whole = 2 * flat_.at(Real(0)).first;
  return {rim.above < 0 ? 1 - half / whole : half / whole, slope / whole};
}

template <class Real>
typename ContainerDensity<Real>::EdgeTable ContainerDensity<Real>::edge(
    const RestLattice& lattice) {
  EdgeTable table;
  const double h = lattice.support_m();
  table.per_m = static_cast<Real>(kEdgeSize / h);
  table.values.reserve((kEdgeSize + 1) * (kEdgeSize + 1));
  for (int a = 0; a <= kEdgeSize; ++a) {
    for (int b = 0; b <= kEdgeSize; ++b) {
      table.values.push_back(
          static_cast<Real>(lattice.behind({h * a / kEdgeSize, h * b / kEdgeSize, 0}, 2)));
    }
  }
  return table;
}

template <class Real>
typename ContainerDensity<Real>::EdgeTable::Sample ContainerDensity<Real>::EdgeTable::at(
    Real a, Real b) const {
  a = std::max(a, Real(0)) * per_m;
  b = std::max(b, Real(0)) * per_m;
  if (!(a < kEdgeSize && b < kEdgeSize)) return {0, 0, 0};
  const auto row = static_cast<std::size_t>(a);
  const auto column = static_cast<std::size_t>(b);
  const Real u = a - static_cast<Real>(row);
  const Real v = b - static_cast<Real>(column);
  const Real* low = &values[row * (kEdgeSize + 1) + column];
  const Real* high = low + kEdgeSize + 1;
  const Real at_low = low[0] + v * (low[1] - low[0]);
  const Real at_high = high[0] + v * (high[1] - high[0]);
  const Real slope_b = (1 - u) * (low[1] - low[0]) + u * (high[1] - high[0]);
  return {at_low + u * (at_high - at_low), (at_high - at_low) * per_m, slope_b * per_m};
}

template <class Real>
std::vector<Real> ContainerDensity<Real>::corner(const RestLattice& lattice) {
  std::vector<Real> values;
  const double step = lattice.support_m() / kCornerSize;
  values.reserve((kCornerSize + 1) * (kCornerSize + 1) * (kCornerSize + 1));
  for (int a = 0; a <= kCornerSize; ++a) {
    for (int b = 0; b <= kCornerSize; ++b) {
      for (int c = 0; c <= kCornerSize; ++c) {
        values.push_back(static_cast<Real>(lattice.behind({a * step, b * step, c * step}, 3)));
      }
    }
  }
  return values;
}

/// Adds the overlap of three walls, interpolated linearly in the table.
template <class Real>
void ContainerDensity<Real>::addCorner(const std::array<NearSurface<Real>, 3>& walls,
                                       WallSample<Real>& sample) const {
  const Real per_m = static_cast<Real>(kCornerSize / support_m_);
  std::array<std::size_t, 3> cell{};
  std::array<Real, 3> part{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Real place = std::max(walls[k].gap + radius_, Real(0)) * per_m;
    cell[k] = std::min(static_cast<std::size_t>(place), std::size_t(kCornerSize - 1));
    part[k] = place - static_cast<Real>(cell[k]);
  }
  for (std::size_t node = 0; node < 8; ++node) {
    const std::array<std::size_t, 3> up{node >> 2, node >> 1 & 1, node & 1};
    std::size_t place = 0;
    std::array<Real, 3> weight{};
    for (std::size_t k = 0; k < 3; ++k) {
      place = place * (kCornerSize + 1) + cell[k] + up[k];
      weight[k] = up[k] ? part[k] : 1 - part[k];
    }
    const Real value = corner_[place];
    sample.value += value * weight[0] * weight[1] * weight[2];
    for (std::size_t k = 0; k < 3; ++k) {
      const Real slope = (up[k] ? per_m : -per_m) * weight[(k + 1) % 3] * weight[(k + 2) % 3];
      sample.gradient += (value * slope) * walls[k].normal;
    }
  }
}

/// Half spaces of all surfaces, minus the overlaps of two, plus the overlap of three.
template <class Real>
WallSample<Real> ContainerDensity<Real>::sumOf(const NearSurfaces<Real>& near) const {
  const NearSurface<Real>* surfaces = near.begin();
  WallSample<Real> sample;
  for (int a = 0; a < near.count; ++a) {
    const NearSurface<Real>& one = surfaces[a];
    const auto [density, slope] = flat_.at(one.gap + radius_);
    sample.value += density;
    sample.gradient += slope * one.normal;
    for (int b = a + 1; b < near.count; ++b) {
      const NearSurface<Real>& two = surfaces[b];
      if (two.axis == one.axis) continue;
      const auto shared = edge_.at(one.gap + radius_, two.gap + radius_);
      sample.value -= shared.value;
      sample.gradient -= shared.slope_a * one.normal;
      sample.gradient -= shared.slope_b * two.normal;
      for (int c = b + 1; c < near.count; ++c) {
        if (surfaces[c].axis != two.axis) addCorner({one, two, surfaces[c]}, sample);
      }
    }
  }
  return sample;
}

/// The floor, and the part of the other half spaces that lies below the rim. Both fade out where a
/// point above the wall counts as outside. An abrupt end would be a step in the density, which
/// ejects particles that cross it.
/// @param near surfaces near rim.below
template <class Real>
WallSample<Real> ContainerDensity<Real>::nearRim(const Rim<Real>& rim, const Vec3<Real>& local,
                                                 NearSurfaces<Real> near) const {
  NearSurfaces<Real> floor;
  for (NearSurface<Real>& wall : near) {
    if (wall.axis != 2) continue;
    wall.gap += local.z() - rim.below.z();
    floor.add(wall);
  }
  const auto [share, slope] = shareBelow(rim);
  const WallSample<Real> bottom = sumOf(floor), all = sumOf(near);
  WallSample<Real> sample;
  sample.value = bottom.value + share * (all.value - bottom.value);
  sample.gradient = bottom.gradient + share * (all.gradient - bottom.gradient);
  sample.gradient.z() += slope * (all.value - bottom.value);
  fadeOverWall(rim, sample);
  return sample;
}

template <class Real>
void ContainerDensity<Real>::fadeOverWall(const Rim<Real>& rim, WallSample<Real>& sample) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (rim.over[axis] <= 0) continue;
    const Real kept = std::max(Real(0), 1 - rim.over[axis] / rim.width[axis]);
    sample.gradient *= kept;
    sample.gradient[int(axis)] -= rim.side[axis] * sample.value / rim.width[axis];
    sample.value *= kept;
  }
}

template <class Real>
std::size_t ContainerDensity<Real>::bytes() const {
  return (edge_.values.capacity() + corner_.capacity()) * sizeof(Real);
}

template class ContainerDensity<float>;
template class ContainerDensity<double>;

}  // namespace ice_ice_baby
