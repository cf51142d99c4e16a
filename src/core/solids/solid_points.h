// The particles that a solid is made of.
//
// They lie in layers along its surface: a lattice in a box, rings in a cylinder and a cup, shells
// in a ball. The outermost centres lie half a layer below the surface, about as those of water that
// touches a wall, so that the surface is flat or round for water and contacts.
#pragma once

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/solid_params.h"

namespace ice_ice_baby {

/// Layers of particles, all of the same thickness, that fill a length.
struct Layers {
  Layers(double length_m, double spacing_m)
      : count(std::max(1L, std::lround(length_m / spacing_m))), step_m(length_m / double(count)) {}
  /// Middle of layer k, from the start of the length.
  double at(long k) const { return (double(k) + 0.5) * step_m; }

  long count;
  double step_m;
};

/// Calls visit(point) for evenly spread points of a ring.
/// @param phase_rad angle of the first
template <class Visit>
void forEachRingPoint(long count, double radius_m, double height_m, double phase_rad,
                      const Visit& visit) {
  for (long k = 0; k < count; ++k) {
    const double angle = phase_rad + 2 * M_PI * double(k) / double(count);
    visit(Vec3d(radius_m * std::cos(angle), radius_m * std::sin(angle), height_m));
  }
}

/// Concentric rings at a distance of `inner_m` from the axis and more, in every one of some layers
/// from a height of `bottom_m` on. Each ring is turned against the one before, so that no points
/// line up.
template <class Visit>
void forEachRoundPoint(const Layers& rings, double inner_m, const Layers& layers, double bottom_m,
                       double spacing_m, const Visit& visit) {
  for (long layer = 0; layer < layers.count; ++layer) {
    for (long k = 0; k < rings.count; ++k) {
      const double radius_m = inner_m + rings.at(k);
      const double volume_m3 = 2 * M_PI * radius_m * rings.step_m * layers.step_m;
      const long count = std::max(1L, std::lround(volume_m3 / std::pow(spacing_m, 3)));
      forEachRingPoint(count, radius_m, bottom_m + layers.at(layer), double(k), visit);
    }
  }
}

template <class Visit>
void forEachPoint(const Box& box, double spacing_m, const Visit& visit) {
  const Layers x(box.size_m.x(), spacing_m);
  const Layers y(box.size_m.y(), spacing_m);
  const Layers z(box.size_m.z(), spacing_m);
  for (long k = 0; k < z.count; ++k) {
    for (long j = 0; j < y.count; ++j) {
      for (long i = 0; i < x.count; ++i) {
        visit(Vec3d(Vec3d(x.at(i), y.at(j), z.at(k)) - box.size_m / 2));
      }
    }
  }
}

/// The points of a shell lie on a spiral from pole to pole (Fibonacci lattice).
template <class Visit>
void forEachPoint(const Sphere& sphere, double spacing_m, const Visit& visit) {
  const double golden_rad = M_PI * (3 - std::sqrt(5.0));
  const Layers shells(sphere.radius_m, spacing_m);
  for (long k = 0; k < shells.count; ++k) {
    const double radius_m = shells.at(k);
    const double step_m = shells.step_m;
    const double volume_m3 = 4 * M_PI * (radius_m * radius_m + step_m * step_m / 12) * step_m;
    const long count = std::max(1L, std::lround(volume_m3 / std::pow(spacing_m, 3)));
    for (long n = 0; n < count; ++n) {
      const double z = 1 - (2 * double(n) + 1) / double(count);
      const double across = std::sqrt(1 - z * z), angle = golden_rad * double(n) + double(k);
      visit(Vec3d(radius_m * Vec3d(across * std::cos(angle), across * std::sin(angle), z)));
    }
  }
}

template <class Visit>
void forEachPoint(const Cylinder& cylinder, double spacing_m, const Visit& visit) {
  const Layers z(cylinder.height_m, spacing_m);
  const Layers rings(cylinder.radius_m, spacing_m);
  forEachRoundPoint(rings, 0.0, z, -cylinder.height_m / 2, spacing_m, visit);
}

/// @param cup with walls of at least a spacing
template <class Visit>
void forEachPoint(const Cup& cup, double spacing_m, const Visit& visit) {
  const Layers wall(cup.wall_m, spacing_m);
  const Layers disc(cup.radius_m + cup.wall_m, spacing_m);
  const Layers z(cup.depth_m, spacing_m);
  forEachRoundPoint(disc, 0.0, wall, -cup.wall_m, spacing_m, visit);
  forEachRoundPoint(wall, cup.radius_m, z, 0.0, spacing_m, visit);
}

/// The solid that the particles fill. The wall of a cup that is thinner than a spacing counts as
/// one spacing thick, inwards; the origin is the middle of that floor.
Solid filledSolid(const Solid& solid, double spacing_m);

/// Calls visit(point) for every particle of a solid, in the frame of the solid.
template <class Visit>
void forEachSolidPoint(const Solid& solid, double spacing_m, const Visit& visit) {
  const Solid filled = filledSolid(solid, spacing_m);
  const Vec3d raised_m = (filled.wall_m - solid.wall_m) * Vec3d::UnitZ();
  visitShape(filled, [&](const auto& shape) {
    forEachPoint(shape, spacing_m, [&](const Vec3d& point) { visit(Vec3d(point + raised_m)); });
  });
}

/// Volume that the particles of a solid stand for, m^3: that of filledSolid.
double filledVolume_m3(const Solid& solid, double spacing_m);

/// Number of particles of a solid, as a double because a scene can ask for more than an integer
/// holds. A solid with more than four times `max_count` is not counted one by one.
double solidCount(const Solid& solid, double spacing_m, double max_count);

}  // namespace ice_ice_baby
