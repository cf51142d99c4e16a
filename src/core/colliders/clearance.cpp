#include "colliders/clearance.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Copies `count` values and repeats the last one up to the end of the tile.
template <class Real>
void load(const std::vector<Real>& values, const std::vector<Real>* by, std::size_t first,
          std::size_t count, std::array<Real, kClearanceTile>& out) {
  std::copy_n(values.data() + first, count, out.begin());
  if (by) {
    for (std::size_t k = 0; k < count; ++k) out[k] += (*by)[first + k];
  }
  std::fill(out.begin() + std::ptrdiff_t(count), out.end(), out[count - 1]);
}

template <class Real>
PointTile<Real> loadTile(const VectorField<Real>& field, const VectorField<Real>* by,
                         std::size_t first, std::size_t count) {
  PointTile<Real> tile;
  load(field.x, by ? &by->x : nullptr, first, count, tile.x);
  load(field.y, by ? &by->y : nullptr, first, count, tile.y);
  load(field.z, by ? &by->z : nullptr, first, count, tile.z);
  return tile;
}

template <class Real>
PointTile<Real> toLocal(const Pose<Real>& pose, const PointTile<Real>& world) {
  const Mat3<Real>& r = pose.rotation;
  const Vec3<Real>& p = pose.position;
  const Real xx = r(0, 0), xy = r(1, 0), xz = r(2, 0);
  const Real yx = r(0, 1), yy = r(1, 1), yz = r(2, 1);
  const Real zx = r(0, 2), zy = r(1, 2), zz = r(2, 2);
  const Real px = p.x(), py = p.y(), pz = p.z();
  PointTile<Real> local;
  for (std::size_t k = 0; k < kClearanceTile; ++k) {
    const Real x = world.x[k] - px, y = world.y[k] - py, z = world.z[k] - pz;
    local.x[k] = xx * x + xy * y + xz * z;
    local.y[k] = yx * x + yy * y + yz * z;
    local.z[k] = zx * x + zy * y + zz * z;
  }
  return local;
}

}  // namespace

template <class Real>
ClearMask clearPaths(const Colliders<Real>& colliders, const Paths<Real>& paths, Real margin_m,
                     std::size_t first, std::size_t count) {
  const PointTile<Real> from = loadTile<Real>(paths.from, nullptr, first, count);
  const PointTile<Real> to = loadTile(paths.to, paths.by, first, count);
  ClearMask clear;
  clear.fill(1);
  for (const MovingShape<Real>& collider : colliders) {
    const PathTile<Real> local{toLocal(collider.motion.from, from), toLocal(collider.motion.to, to),
                               margin_m};
    collider.shape.clear(local, clear);
  }
  return clear;
}

template ClearMask clearPaths(const Colliders<float>&, const Paths<float>&, float, std::size_t,
                              std::size_t);
template ClearMask clearPaths(const Colliders<double>&, const Paths<double>&, double, std::size_t,
                              std::size_t);

}  // namespace ice_ice_baby
