// Volume, mass, centre of mass and inertia of the true shape of a solid, in closed form.
#pragma once

#include "ice_ice_baby/solid_params.h"

namespace ice_ice_baby {

struct SolidMass {
  double volume_m3 = 0.0;  ///< of the material
  double mass_kg = 0.0;
  Vec3d centre_m = Vec3d::Zero();               ///< of mass, in the frame of the solid
  Mat3<double> inertia = Mat3<double>::Zero();  ///< kg m^2 about the centre, axes of the solid
};

SolidMass massOf(const Solid& solid);

}  // namespace ice_ice_baby
