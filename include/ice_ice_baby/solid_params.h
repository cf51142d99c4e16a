// Floating solids of a scene as plain data, and their keys, as in params.h.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/collider_params.h"

namespace ice_ice_baby {

enum class SolidShape { kBox, kSphere, kCylinder, kCup };

inline std::vector<std::string> choices(SolidShape) { return {"box", "sphere", "cylinder", "cup"}; }

/// Rigid body that falls, floats and collides. Its shapes are those of the colliders, and so is the
/// point that its position refers to.
struct Solid {
  std::string name;
  SolidShape shape = SolidShape::kBox;
  Vec3d position_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  Vec3d velocity_m_s = Vec3d::Zero();            ///< of the centre of mass
  Vec3d angular_velocity_rad_s = Vec3d::Zero();  ///< about the axes of the scene
  double density_kg_m3 = 500.0;                  ///< of the material
  double mass_kg = 0.0;                          ///< 0: follows from the density
  double friction = 0.3;
  double opacity = 1.0;
  Vec3d size_m = Vec3d::Constant(0.1);
  double radius_m = 0.05;
  double height_m = 0.1;
  double wall_m = 0.01;

  /// Pose in the scene frame.
  Posed pose() const { return poseOf(position_m, rpy_deg); }
};

template <class Visitor>
void describe(Solid& s, Visitor&& visit) {
  visit("name", s.name, "name used by services and tf; \"\": solid_0, solid_1, ...");
  visit("shape", s.shape, "its shape, as that of a collider");
  visit("position_m", s.position_m, kCoordinateRange_m,
        "position of the centre; cup: centre of the inner floor");
  visit("rpy_deg", s.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw about the fixed axes x, y, z");
  visit("velocity_m_s", s.velocity_m_s, Range{-1e3, 1e3}, "initial velocity of the centre of mass");
  visit("angular_velocity_rad_s", s.angular_velocity_rad_s, Range{-1e3, 1e3},
        "initial angular velocity");
  visit("density_kg_m3", s.density_kg_m3, Range{1e-3, 1e9},
        "density of the material; from 0.1 to 20 times fluid.rest_density_kg_m3");
  visit("mass_kg", s.mass_kg, Range{0.0, 1e9}, "mass; 0: follows from density_kg_m3");
  visit("friction", s.friction, Range{0.0, 10.0},
        "Coulomb friction coefficient on colliders and ice; of two solids the mean counts");
  visit("opacity", s.opacity, Range{0.0, 1.0}, "opacity in markers; 0: invisible");
  visit("size_m", s.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "box: length of its sides");
  visit("radius_m", s.radius_m, Range{1e-3, kMaxCoordinate_m},
        "sphere, cylinder: radius; cup: inner radius");
  visit("height_m", s.height_m, Range{1e-3, 2 * kMaxCoordinate_m},
        "cylinder: height along the local z; cup: from the floor to the rim");
  visit("wall_m", s.wall_m, Range{1e-4, 10.0}, "cup: thickness of wall and floor");
}

/// Largest number of solids in a scene.
constexpr std::size_t kMaxSolids = 1000;

/// Calls visit(params) with the collider of the same shape, size and pose as a solid: a Box, a
/// Sphere, a Cylinder or a Cup.
template <class Visit>
decltype(auto) visitShape(const Solid& solid, const Visit& visit) {
  const auto placed = [&](auto shape) {
    shape.name = solid.name;
    shape.position_m = solid.position_m;
    shape.rpy_deg = solid.rpy_deg;
    shape.friction = solid.friction;
    shape.opacity = solid.opacity;
    return shape;
  };
  switch (solid.shape) {
    case SolidShape::kSphere: {
      Sphere sphere = placed(Sphere());
      sphere.radius_m = solid.radius_m;
      return visit(sphere);
    }
    case SolidShape::kCylinder: {
      Cylinder cylinder = placed(Cylinder());
      cylinder.radius_m = solid.radius_m;
      cylinder.height_m = solid.height_m;
      return visit(cylinder);
    }
    case SolidShape::kCup: {
      Cup cup = placed(Cup());
      cup.radius_m = solid.radius_m;
      cup.depth_m = solid.height_m;
      cup.wall_m = solid.wall_m;
      return visit(cup);
    }
    case SolidShape::kBox:
      break;
  }
  Box box = placed(Box());
  box.size_m = solid.size_m;
  return visit(box);
}

}  // namespace ice_ice_baby
