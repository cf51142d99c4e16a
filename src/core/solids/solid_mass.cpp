#include "solids/solid_mass.h"

#include <cmath>

namespace ice_ice_baby {

namespace {

Mat3<double> diagonal(double x, double y, double z) { return Vec3d(x, y, z).asDiagonal(); }

/// What the inertia about the centre of mass gains about a point that lies `arm` away.
Mat3<double> offCentre(double mass_kg, const Vec3d& arm) {
  return mass_kg * (arm.squaredNorm() * Mat3<double>::Identity() - arm * arm.transpose());
}

/// Shapes of density 1.
SolidMass unitMass(const Box& box) {
  const Vec3d square = box.size_m.cwiseAbs2();
  const double volume = box.size_m.prod();
  return {volume, volume, Vec3d::Zero(),
          volume / 12 *
              diagonal(square.y() + square.z(), square.x() + square.z(), square.x() + square.y())};
}

SolidMass unitMass(const Sphere& sphere) {
  const double square = sphere.radius_m * sphere.radius_m;
  const double volume = 4 * M_PI / 3 * square * sphere.radius_m;
  return {volume, volume, Vec3d::Zero(), 0.4 * volume * square * Mat3<double>::Identity()};
}

SolidMass unitMass(const Cylinder& cylinder) {
  const double square = cylinder.radius_m * cylinder.radius_m;
  const double volume = M_PI * square * cylinder.height_m;
  const double across = volume * (square / 4 + cylinder.height_m * cylinder.height_m / 12);
  return {volume, volume, Vec3d::Zero(), diagonal(across, across, volume * square / 2)};
}

/// The outer cylinder without the inner one.
SolidMass unitMass(const Cup& cup) {
  Cylinder outer, inner;
  outer.radius_m = cup.radius_m + cup.wall_m;
  outer.height_m = cup.depth_m + cup.wall_m;
  inner.radius_m = cup.radius_m;
  inner.height_m = cup.depth_m;
  const SolidMass whole = unitMass(outer), hollow = unitMass(inner);
  const Vec3d at_whole((cup.depth_m - cup.wall_m) / 2 * Vec3d::UnitZ());
  const Vec3d at_hollow(cup.depth_m / 2 * Vec3d::UnitZ());
  SolidMass rest;
  rest.volume_m3 = rest.mass_kg = whole.volume_m3 - hollow.volume_m3;
  rest.centre_m = (whole.volume_m3 * at_whole - hollow.volume_m3 * at_hollow) / rest.volume_m3;
  rest.inertia = whole.inertia + offCentre(whole.volume_m3, at_whole - rest.centre_m) -
                 hollow.inertia - offCentre(hollow.volume_m3, at_hollow - rest.centre_m);
  return rest;
}

}  // namespace

SolidMass massOf(const Solid& solid) {
  SolidMass mass = visitShape(solid, [](const auto& shape) { return unitMass(shape); });
  const double density_kg_m3 =
      solid.mass_kg > 0.0 ? solid.mass_kg / mass.volume_m3 : solid.density_kg_m3;
  mass.mass_kg *= density_kg_m3;
  mass.inertia *= density_kg_m3;
  return mass;
}

}  // namespace ice_ice_baby
