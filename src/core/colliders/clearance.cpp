#include "colliders/clearance.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr std::size_t kSize = kClearanceTile;

/// Points side by side.
template <class Real>
struct Tile {
  std::array<Real, kSize> x, y, z;
};

/// `count` values, and the last of them again up to the end of the tile.
template <class Real>
void load(const std::vector<Real>& values, const std::vector<Real>* by, std::size_t first,
          std::size_t count, std::array<Real, kSize>& out) {
  std::copy_n(values.data() + first, count, out.begin());
  if (by) {
    for (std::size_t k = 0; k < count; ++k) out[k] += (*by)[first + k];
  }
  std::fill(out.begin() + std::ptrdiff_t(count), out.end(), out[count - 1]);
}

template <class Real>
Tile<Real> loadTile(const VectorField<Real>& field, const VectorField<Real>* by, std::size_t first,
                    std::size_t count) {
  Tile<Real> tile;
  load(field.x, by ? &by->x : nullptr, first, count, tile.x);
  load(field.y, by ? &by->y : nullptr, first, count, tile.y);
  load(field.z, by ? &by->z : nullptr, first, count, tile.z);
  return tile;
}

template <class Real>
Tile<Real> toLocal(const Pose<Real>& pose, const Tile<Real>& world) {
  const Mat3<Real>& r = pose.rotation;
  const Vec3<Real>& p = pose.position;
  const Real xx = r(0, 0), xy = r(1, 0), xz = r(2, 0);
  const Real yx = r(0, 1), yy = r(1, 1), yz = r(2, 1);
  const Real zx = r(0, 2), zy = r(1, 2), zz = r(2, 2);
  const Real px = p.x(), py = p.y(), pz = p.z();
  Tile<Real> local;
  for (std::size_t k = 0; k < kSize; ++k) {
    const Real x = world.x[k] - px, y = world.y[k] - py, z = world.z[k] - pz;
    local.x[k] = xx * x + xy * y + xz * z;
    local.y[k] = yx * x + yy * y + yz * z;
    local.z[k] = zx * x + zy * y + zz * z;
  }
  return local;
}

/// Both ends strictly between two values.
template <class Real>
std::uint32_t within(Real a, Real b, Real low, Real high) {
  return std::uint32_t(a > low) & std::uint32_t(b > low) & std::uint32_t(a < high) &
         std::uint32_t(b < high);
}

/// Both ends beyond the same of two values.
template <class Real>
std::uint32_t beyond(Real a, Real b, Real low, Real high) {
  return (std::uint32_t(a < low) & std::uint32_t(b < low)) |
         (std::uint32_t(a > high) & std::uint32_t(b > high));
}

template <class Real>
void clearOf(const ContainerShape<Real>& shape, const Tile<Real>& from, const Tile<Real>& to,
             Real margin, ClearMask& clear) {
  const Vec3<Real> m = Vec3<Real>::Constant(margin);
  const Vec3<Real> low = shape.inner.low + m, high = shape.inner.high - m;
  const Vec3<Real> out_low = shape.outer.low - m, out_high = shape.outer.high + m;
  for (std::size_t k = 0; k < kSize; ++k) {
    const std::uint32_t inside = within(from.x[k], to.x[k], low.x(), high.x()) &
                                 within(from.y[k], to.y[k], low.y(), high.y()) &
                                 within(from.z[k], to.z[k], low.z(), high.z());
    const std::uint32_t outside = beyond(from.x[k], to.x[k], out_low.x(), out_high.x()) |
                                  beyond(from.y[k], to.y[k], out_low.y(), out_high.y()) |
                                  beyond(from.z[k], to.z[k], out_low.z(), out_high.z());
    clear[k] &= inside | outside;
  }
}

template <class Real>
void clearOf(const PlaneShape<Real>& shape, const Tile<Real>& from, const Tile<Real>& to,
             Real margin, ClearMask& clear) {
  const Real above = shape.surface + margin;
  for (std::size_t k = 0; k < kSize; ++k) {
    clear[k] &= std::uint32_t(from.z[k] > above) & std::uint32_t(to.z[k] > above);
  }
}

template <class Real>
void clearOf(const SphereShape<Real>& shape, const Tile<Real>& from, const Tile<Real>& to,
             Real margin, ClearMask& clear) {
  const Real reach = shape.reach + margin;
  for (std::size_t k = 0; k < kSize; ++k) {
    const Real x = to.x[k] - from.x[k], y = to.y[k] - from.y[k], z = to.z[k] - from.z[k];
    // The sum of three lengths is no shorter than the path.
    const Real bound = reach + std::abs(x) + std::abs(y) + std::abs(z);
    const Real square = from.x[k] * from.x[k] + from.y[k] * from.y[k] + from.z[k] * from.z[k];
    clear[k] &= std::uint32_t(square > bound * bound);
  }
}

}  // namespace

template <class Real>
ClearMask clearPaths(const Colliders<Real>& colliders, const Paths<Real>& paths, Real margin_m,
                     std::size_t first, std::size_t count) {
  const Tile<Real> from = loadTile<Real>(paths.from, nullptr, first, count);
  const Tile<Real> to = loadTile(paths.to, paths.by, first, count);
  ClearMask clear;
  clear.fill(1);
  const auto narrow = [&](const auto& bodies) {
    for (const auto& body : bodies) {
      clearOf(body.shape, toLocal(body.motion.from, from), toLocal(body.motion.to, to), margin_m,
              clear);
    }
  };
  narrow(colliders.containers);
  narrow(colliders.planes);
  narrow(colliders.spheres);
  return clear;
}

template ClearMask clearPaths(const Colliders<float>&, const Paths<float>&, float, std::size_t,
                              std::size_t);
template ClearMask clearPaths(const Colliders<double>&, const Paths<double>&, double, std::size_t,
                              std::size_t);

}  // namespace ice_ice_baby
