// Which surfaces of colliders lie near a point, as those see them who let water go on behind walls.
#pragma once

#include <array>

#include "colliders/colliders.h"

namespace ice_ice_baby {

/// A wall of a box near a point: its axis, the distance to it, the sign of its inward normal.
template <class Real>
struct NearWall {
  int axis;
  Real distance;
  Real sign;
};

template <class Real>
struct NearWalls {
  std::array<NearWall<Real>, 6> walls;
  int count = 0;

  const NearWall<Real>* begin() const { return walls.data(); }
  const NearWall<Real>* end() const { return walls.data() + count; }
};

/// Walls of a container nearer than `reach_m` to a point inside it; none for a point outside.
/// @param local the point in the container's own frame
/// @param radius_m half the spacing, by which the shape is shrunk
template <class Real>
NearWalls<Real> nearWalls(const ContainerShape<Real>& shape, const Vec3<Real>& local, Real radius_m,
                          Real reach_m) {
  NearWalls<Real> near;
  const Vec3<Real> from_low = local - shape.inner.low;
  const Vec3<Real> from_high = shape.inner.high - local;
  const Real nearest = from_low.cwiseMin(from_high).minCoeff();
  if (nearest >= reach_m - radius_m || !shape.inside(local)) return near;
  for (int axis = 0; axis < 3; ++axis) {
    const Real low = from_low[axis] + radius_m;
    const Real high = from_high[axis] + radius_m;
    const bool open = axis == 2 && shape.open_top;
    if (low < reach_m) near.walls[std::size_t(near.count++)] = {axis, low, 1};
    if (high < reach_m && !open) near.walls[std::size_t(near.count++)] = {axis, high, -1};
  }
  return near;
}

/// Distance of a point above a plane or the top of a plate; below 0 beneath it and beside a plate.
template <class Real>
Real heightAbove(const Body<Real, PlaneShape<Real>>& body, const Vec3<Real>& point, Real radius_m) {
  const Vec3<Real> local = body.motion.to.toLocal(point);
  const BoxShape<Real>& plate = body.shape.plate;
  const bool beside =
      !body.shape.infinite && ((local.head(2).array() < plate.low.head(2).array()).any() ||
                               (local.head(2).array() > plate.high.head(2).array()).any());
  return beside ? Real(-1) : local.z() - body.shape.surface + radius_m;
}

/// Whether the nearest point of something else lies behind a wall of the container that holds the
/// point: a ground just under a container must not count on top of its floor.
/// @param flush whether that also holds for what lies flush with the wall
template <class Real>
bool hiddenByWall(const Colliders<Real>& colliders, const Vec3<Real>& point,
                  const Vec3<Real>& nearest, Real radius_m, bool flush) {
  const Real hair = Real(flush ? 1e-3 : -1e-3) * radius_m;
  for (const auto& body : colliders.containers) {
    if (!body.shape.inside(body.motion.to.toLocal(point))) continue;
    const Vec3<Real> local = body.motion.to.toLocal(nearest);
    const auto low = body.shape.inner.low.array() - radius_m + hair;
    const auto high = body.shape.inner.high.array() + radius_m - hair;
    if ((local.array() < low).any() || (local.array() > high).any()) return true;
  }
  return false;
}

}  // namespace ice_ice_baby
