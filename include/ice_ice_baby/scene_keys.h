// The keys of a scene file, in the order in which config/default.yaml lists them (see params.h).
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

template <class Visitor>
void describe(TemperatureEvent& e, Visitor&& visit) {
  visit("at_s", e.at_s, Range{0.0, 1e6}, "simulated time");
  visit("celsius", e.celsius, kTemperatureRange_c, "temperature to reach");
  visit("ramp_s", e.ramp_s, Range{0.0, 1e6}, "time to get there; 0: at once");
}

template <class Visitor>
void describe(Block& b, Visitor&& visit) {
  visit(
      "shape", b.shape,
      "the whole box from min_m to max_m, or the sphere or upright cylinder that just fits in it");
  visit("min_m", b.min_m, kCoordinateRange_m, "lower corner");
  visit("max_m", b.max_m, kCoordinateRange_m, "upper corner");
  visit("rpy_deg", b.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw by which the block and its lattice are turned about its centre");
  visit("velocity_m_s", b.velocity_m_s, Range{-1e3, 1e3}, "velocity of the centre at the start");
  visit("velocity_gradient_1_s", b.velocity_gradient_1_s, Range{-1e3, 1e3},
        "added velocity per metre from the centre: rows of vx, vy, vz, columns along x, y, z");
  visit("angular_velocity_rad_s", b.angular_velocity_rad_s, Range{-1e3, 1e3},
        "added rotation about the centre");
  visit("celsius", b.celsius, kTemperatureRange_c,
        "temperature at the start, with thermal.enabled: below thermal.freezing_c a body of ice");
  visit("sheet", b.sheet,
        "one layer of particles joined by springs that bend, neither stretch nor melt");
  visit("copies", b.copies, Range{1.0, 1000.0},
        "how many of this block stand along x, y, z: whole numbers, at most 1000 together");
  visit("copies_step_m", b.copies_step_m, kCoordinateRange_m,
        "distance along each axis from one copy to the next");
}

template <class Visitor>
void describeCollider(Collider& c, Visitor&& visit) {
  visit("name", c.name, "how services and tf call it");
  visit("position_m", c.position_m, kCoordinateRange_m,
        "of the centre: of a container its inner floor, of a plane its surface");
  visit("rpy_deg", c.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw about the fixed axes x, y, z");
  visit("friction", c.friction, Range{0.0, 10.0}, "Coulomb coefficient; 0: slippery");
  visit("opacity", c.opacity, Range{0.0, 1.0}, "in pictures; 0: invisible");
  visit("follow_frame", c.follow_frame, "tf frame that the collider moves with; \"\": it stays");
  visit(
      "heat", c.heat,
      "what its surface does to the water, with thermal.enabled: nothing, it has a temperature, or "
      "it passes a flux");
  visit("celsius", c.celsius, kTemperatureRange_c, "temperature of the surface, for temperature");
  visit("flux_w_m2", c.flux_w_m2, Range{-1e7, 1e7}, "into the water, for flux; below 0 it cools");
}

template <class Visitor>
void describe(Container& c, Visitor&& visit) {
  describeCollider(c, visit);
  visit("size_m", c.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "inner size");
  visit("wall_m", c.wall_m, Range{1e-4, 10.0}, "thickness of walls and floor");
  visit("open_top", c.open_top, "whether water can leave by the top");
}

template <class Visitor>
void describe(Plane& p, Visitor&& visit) {
  describeCollider(p, visit);
  visit("size_x_m", p.size_x_m, Range{0.0, 2 * kMaxCoordinate_m}, "0: infinite");
  visit("size_y_m", p.size_y_m, Range{0.0, 2 * kMaxCoordinate_m}, "0: infinite");
  visit("thickness_m", p.thickness_m, Range{1e-4, 10.0}, "of a plate that is not infinite");
}

template <class Visitor>
void describe(Sphere& s, Visitor&& visit) {
  describeCollider(s, visit);
  visit("radius_m", s.radius_m, Range{1e-3, kMaxCoordinate_m}, "radius");
}

template <class Visitor>
void describe(Scene& s, Visitor&& visit) {
  visit("name", s.name, "what it is called");
  visit("description", s.description, "what is to be seen, in a sentence");
  visit(
      "preset", s.preset,
      "method whose keys hold where the scene does not set them: default, or as the paper has it");
  visit("duration_s", s.duration_s, Range{0.0, 1e6}, "how long run_scene runs it");
  visit("gravity_m_s2", s.gravity_m_s2, kGravityRange_m_s2, "gravity");
  visit.section("fluid", s.fluid, "the particles and how their density is measured");
  visit.section("solver", s.solver, "error against run time");
  visit.section("temperature", s.temperature,
                "one temperature for the whole scene; with thermal.enabled that of the air");
  visit.section("springs", s.springs, "what freezing does; a liquid scene has no springs");
  visit.section("thermal", s.thermal, "temperature of every particle, freezing fronts, boiling");
  visit.section("ice", s.ice, "what frozen water does, with thermal.enabled");
  visit.section("steam", s.steam, "what boiled water does, with thermal.enabled");
  visit.section("limits", s.limits, "guards");
  visit.list("schedule", s.schedule, "temperature over time");
  visit.list("blocks", s.blocks, "the water");
  visit.list("containers", s.containers, "boxes that hold water");
  visit.list("planes", s.planes, "grounds and plates");
  visit.list("spheres", s.spheres, "balls");
}

}  // namespace ice_ice_baby
