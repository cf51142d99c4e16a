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
  forEachColliderList(
      s, [&](auto& list, const ColliderKind& kind) { visit.list(kind.key, list, kind.meaning); });
}

}  // namespace ice_ice_baby
