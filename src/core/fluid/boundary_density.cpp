#include "fluid/boundary_density.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr int kEdgeSize = 64;
constexpr int kCornerSize = 32;

double kernelValue(KernelPair pair, double h, double r) {
  return pair == KernelPair::kCubic ? CubicSpline<double>(h).w(r) : Poly6<double>(h).w(r);
}

/// Fraction of the surface of a sphere of radius r inside a ball whose centre is at `distance`.
double shareInside(double r, double distance, double ball) {
  const double cosine = (distance * distance + r * r - ball * ball) / (2 * distance * r);
  return 0.5 * (1 - std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

template <class Real>
BoundaryDensity<Real>::BoundaryDensity(const Scene& scene, const Colliders<Real>& colliders,
                                       double volume_m3)
    : colliders_(colliders),
      kernel_(scene.fluid.kernel),
      h_(scene.supportRadius_m()),
      spacing_(scene.fluid.spacing_m),
      volume_(volume_m3),
      radius_(static_cast<Real>(spacing_ / 2)) {
  tables_.push_back(halfSpace());
  if (colliders.anyHollow()) {
    edge_ = edge();
    corner_ = corner();
  }
  for (const MovingShape<Real>& collider : colliders) {
    table_of_.push_back(collider.shape.flat() ? 0 : tables_.size());
    if (!collider.shape.flat()) tables_.push_back(ball(collider.shape.curvatureRadius()));
  }
}

/// Sum over the lattice behind `walls` walls at right angles, in the region behind all of them.
template <class Real>
double BoundaryDensity<Real>::ghosts(const std::array<double, 3>& distances, int walls) const {
  const int reach = static_cast<int>(h_ / spacing_) + 1;
  const auto offset = [&](int axis, int k) {
    return axis < walls ? distances[std::size_t(axis)] + (k + 0.5) * spacing_ : k * spacing_;
  };
  const auto first = [&](int axis) { return axis < walls ? 0 : -reach; };
  double sum = 0.0;
  for (int x = first(0); x <= reach; ++x) {
    for (int y = first(1); y <= reach; ++y) {
      for (int z = first(2); z <= reach; ++z) {
        const Vec3d ghost(offset(0, x), offset(1, y), offset(2, z));
        sum += kernelValue(kernel_, h_, ghost.norm());
      }
    }
  }
  return volume_ * sum;
}

template <class Real>
DistanceTable<Real> BoundaryDensity<Real>::halfSpace() const {
  return DistanceTable<Real>(h_, [&](double distance) { return ghosts({distance, 0, 0}, 1); });
}

template <class Real>
DistanceTable<Real> BoundaryDensity<Real>::ball(Real radius) const {
  constexpr int kShells = 400;
  return DistanceTable<Real>(h_, [&](double distance) {
    double sum = 0.0;
    for (int k = 0; k < kShells; ++k) {
      const double r = h_ * (k + 0.5) / kShells;
      sum += 4 * M_PI * r * r * kernelValue(kernel_, h_, r) *
             shareInside(r, distance + double(radius), double(radius)) * h_ / kShells;
    }
    return sum;
  });
}

template <class Real>
typename BoundaryDensity<Real>::EdgeTable BoundaryDensity<Real>::edge() const {
  EdgeTable table;
  table.per_m = static_cast<Real>(kEdgeSize / h_);
  table.values.reserve((kEdgeSize + 1) * (kEdgeSize + 1));
  for (int a = 0; a <= kEdgeSize; ++a) {
    for (int b = 0; b <= kEdgeSize; ++b) {
      table.values.push_back(
          static_cast<Real>(ghosts({h_ * a / kEdgeSize, h_ * b / kEdgeSize, 0}, 2)));
    }
  }
  return table;
}

template <class Real>
typename BoundaryDensity<Real>::EdgeTable::Sample BoundaryDensity<Real>::EdgeTable::at(
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
std::vector<Real> BoundaryDensity<Real>::corner() const {
  std::vector<Real> values;
  const double step = h_ / kCornerSize;
  values.reserve((kCornerSize + 1) * (kCornerSize + 1) * (kCornerSize + 1));
  for (int a = 0; a <= kCornerSize; ++a) {
    for (int b = 0; b <= kCornerSize; ++b) {
      for (int c = 0; c <= kCornerSize; ++c) {
        values.push_back(static_cast<Real>(ghosts({a * step, b * step, c * step}, 3)));
      }
    }
  }
  return values;
}

/// Adds the overlap of three walls, interpolated linearly in the table.
template <class Real>
void BoundaryDensity<Real>::addCorner(const std::array<NearSurface<Real>, 3>& walls,
                                      WallSample<Real>& sample) const {
  const Real per_m = static_cast<Real>(kCornerSize / h_);
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
WallSample<Real> BoundaryDensity<Real>::sumOf(const NearSurfaces<Real>& near,
                                              const DistanceTable<Real>& table) const {
  const NearSurface<Real>* surfaces = near.begin();
  WallSample<Real> sample;
  for (int a = 0; a < near.count; ++a) {
    const NearSurface<Real>& one = surfaces[a];
    const auto [density, slope] = table.at(one.gap + radius_);
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
WallSample<Real> BoundaryDensity<Real>::nearRim(const Rim<Real>& rim, const Vec3<Real>& local,
                                                NearSurfaces<Real> near) const {
  NearSurfaces<Real> floor;
  for (NearSurface<Real>& wall : near) {
    if (wall.axis != 2) continue;
    wall.gap += local.z() - rim.below.z();
    floor.add(wall);
  }
  const DistanceTable<Real>& flat = tables_.front();
  const auto [half, slope] = flat.at(std::abs(rim.above));
  const Real whole = 2 * flat.at(Real(0)).first;
  const Real share = rim.above < 0 ? 1 - half / whole : half / whole;
  const WallSample<Real> bottom = sumOf(floor, flat), all = sumOf(near, flat);
  WallSample<Real> sample;
  sample.value = bottom.value + share * (all.value - bottom.value);
  sample.gradient = bottom.gradient + share * (all.gradient - bottom.gradient);
  sample.gradient.z() += slope / whole * (all.value - bottom.value);
  fadeOverWall(rim, sample);
  return sample;
}

template <class Real>
void BoundaryDensity<Real>::fadeOverWall(const Rim<Real>& rim, WallSample<Real>& sample) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (rim.over[axis] <= 0) continue;
    const Real kept = std::max(Real(0), 1 - rim.over[axis] / rim.width[axis]);
    sample.gradient *= kept;
    sample.gradient[int(axis)] -= rim.side[axis] * sample.value / rim.width[axis];
    sample.value *= kept;
  }
}

template <class Real>
WallSample<Real> BoundaryDensity<Real>::at(const Vec3<Real>& point) const {
  WallSample<Real> sample;
  const Real h = static_cast<Real>(h_);
  for (std::size_t k = 0; k < colliders_.count(); ++k) {
    const Shape<Real>& shape = colliders_[k].shape;
    const Pose<Real>& pose = colliders_[k].motion.to;
    const Vec3<Real> local = pose.toLocal(point);
    const auto rim = shape.rim(local, h);
    const NearSurfaces<Real> near = shape.near(rim ? rim->below : local, h);
    if (near.count == 0) continue;
    const WallSample<Real> one =
        rim ? nearRim(*rim, local, near) : sumOf(near, tables_[table_of_[k]]);
    if (one.value == 0) continue;
    if (!shape.hollow()) {
      const NearSurface<Real>& nearest = *near.begin();
      const Vec3<Real> to_foot = (nearest.gap + radius_) * (pose.rotation * nearest.normal);
      if (colliders_.hidden(point, point - to_foot, true)) continue;
    }
    sample.value += one.value;
    sample.gradient += pose.rotation * one.gradient;
  }
  return sample;
}

template <class Real>
std::size_t BoundaryDensity<Real>::bytes() const {
  std::size_t total = (edge_.values.capacity() + corner_.capacity()) * sizeof(Real) +
                      table_of_.capacity() * sizeof(std::size_t);
  for (const DistanceTable<Real>& table : tables_) total += table.bytes();
  return total;
}

template class BoundaryDensity<float>;
template class BoundaryDensity<double>;

}  // namespace ice_ice_baby
