#include "meshes/surface_contact.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Lacking less than this, in radii, a particle is left where it is.
constexpr double kRounding_r = 1e-5;
/// A path with a smaller cosine to the direction away from the surface neither nears nor leaves it.
constexpr double kParallel = 1e-6;
/// Closer than this, in radii, a particle touches.
constexpr double kTouching_r = 1.001;
/// Particles keep at least this distance, in radii, where there is no room for a radius.
constexpr double kKept_r = 0.2;
/// Share of the distance to the surface that a single advance covers.
constexpr double kAdvance = 0.9;
constexpr int kMaxAdvances = 64, kMaxSlides = 5, kMaxPushes = 12;

/// Unit vector from a surface to a point beside it.
Vec3d awayFrom(const Surface& surface, const SurfacePoint& near, const Vec3d& x) {
  if (near.distance_m > 0) return (x - near.point) / near.distance_m;
  return surface.tree().triangle(near.triangle).normal().normalized();
}

/// Moves a point to a radius from the surface. It never moves by more than its distance from the
/// surface, so it stays on its side.
/// @param near the point of the surface that is closest to x, if it is within a radius
Vec3d pushedOut(const Surface& surface, Vec3d x, SurfacePoint near) {
  const double radius = surface.radius_m();
  Vec3d kept = x;
  for (int k = 0; k < kMaxPushes; ++k) {
    if (!near.found() || near.distance_m >= radius * (1 - kRounding_r)) return x;
    if (near.distance_m >= kKept_r * radius) kept = x;
    const double lacking = radius - near.distance_m;
    x += std::min(lacking, std::max(kAdvance * near.distance_m, 1e-3 * radius)) *
         awayFrom(surface, near, x);
    near = surface.closest(x, radius);
  }
  return near.distance_m >= kKept_r * radius ? x : kept;
}

/// Goes along a path until it touches the surface. @return the surface it touches, if any
SurfacePoint advance(const Surface& surface, Vec3d& x, Vec3d& way) {
  const double radius = surface.radius_m();
  for (int k = 0; k < kMaxAdvances; ++k) {
    const double left = way.norm();
    if (left == 0) return {};
    const SurfacePoint near = surface.closest(x, left + radius);
    if (!near.found()) {
      x += way;
      way.setZero();
      return {};
    }
    const bool approaching = way.dot(x - near.point) < -kParallel * left * near.distance_m;
    if (approaching && near.distance_m <= kTouching_r * radius) return near;
    const double free =
        approaching ? std::max(near.distance_m - radius, near.distance_m / 8) : near.distance_m / 2;
    const double share = std::min(1.0, free / left);
    x += share * way;
    way *= 1 - share;
  }
  way.setZero();
  return {};
}

}  // namespace

Vec3d endBeside(const Surface& surface, const Vec3d& from, const Vec3d& to) {
  const double radius = surface.radius_m();
  const double length = (to - from).norm();
  if (surface.atLeast(to) > radius + length) return to;
  // A path shorter than the distance of its end from the surface cannot have passed it.
  if (length < radius) {
    const SurfacePoint near = surface.closest(to, radius);
    if (!near.found()) return to;
    if (length < near.distance_m) return pushedOut(surface, to, near);
  }
  Vec3d x = from, way = to - from;
  for (int slide = 0; slide < kMaxSlides; ++slide) {
    const SurfacePoint near = advance(surface, x, way);
    if (!near.found()) break;
    const Vec3d normal = awayFrom(surface, near, x);
    way -= std::min(0.0, way.dot(normal)) * normal;
  }
  return pushedOut(surface, x, surface.closest(x, radius));
}

}  // namespace ice_ice_baby
