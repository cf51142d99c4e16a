// The keys of a scene file, in the order of config/default.yaml; see params.h.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

template <class Visitor>
void describe(TemperatureEvent& e, Visitor&& visit) {
  visit("at_s", e.at_s, Range{0.0, 1e6}, "simulated time at which the change starts");
  visit("celsius", e.celsius, kTemperatureRange_c, "target temperature");
  visit("ramp_s", e.ramp_s, Range{0.0, 1e6}, "time to reach it; 0: at once");
}

template <class Visitor>
void describe(Block& b, Visitor&& visit) {
  visit("shape", b.shape,
        "box from min_m to max_m, or the sphere or upright cylinder inscribed in it");
  visit("min_m", b.min_m, kCoordinateRange_m, "lower corner");
  visit("max_m", b.max_m, kCoordinateRange_m, "upper corner");
  visit("rpy_deg", b.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw of the block and its lattice about its centre");
  visit("velocity_m_s", b.velocity_m_s, Range{-1e3, 1e3}, "initial velocity of the centre");
  visit("velocity_gradient_1_s", b.velocity_gradient_1_s, Range{-1e3, 1e3},
        "added velocity per metre from the centre: rows vx, vy, vz; columns x, y, z");
  visit("angular_velocity_rad_s", b.angular_velocity_rad_s, Range{-1e3, 1e3},
        "added angular velocity about the centre");
  visit("celsius", b.celsius, kTemperatureRange_c,
        "initial temperature, with thermal.enabled; below thermal.freezing_c the block is ice");
  visit("sheet", b.sheet,
        "one layer of particles joined by springs; it bends, but does not stretch or melt");
  visit("carve", b.carve,
        "whether particles that would lie in a collider or touch it are left out; false: a block "
        "that reaches into a collider is refused");
  visit("copies", b.copies, Range{1.0, 1000.0},
        "number of copies along x, y, z: whole numbers, at most 1000 in total");
  visit("copies_step_m", b.copies_step_m, kCoordinateRange_m,
        "distance between copies along each axis");
  visit("frame", b.frame,
        "collider in whose frame the block and its velocities are given; \"\": that of the scene");
}

template <class Visitor>
void describe(Gauge& g, Visitor&& visit) {
  visit("name", g.name, "name in what is measured; no collider may have it too");
  visit("position_m", g.position_m, kCoordinateRange_m, "position of the centre");
  visit("rpy_deg", g.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw about the fixed axes x, y, z");
  visit("size_m", g.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "length of its sides");
  visit("frame", g.frame,
        "collider in whose frame the gauge lies and with which it moves; \"\": that of the scene");
}

template <class Visitor>
void describe(HeatRegionParams& r, Visitor&& visit) {
  visit("name", r.name, "name used by services; \"\": heat_region_0, heat_region_1, ...");
  visit("shape", r.shape, "box, or sphere: the ellipsoid that fits into the box");
  visit("position_m", r.position_m, kCoordinateRange_m, "position of the centre");
  visit("rpy_deg", r.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw about the fixed axes x, y, z");
  visit("size_m", r.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "length of the sides of the box");
  visit("power_w", r.power_w, kPowerRange_w,
        "power spread over the water and ice inside; below 0: cools; not 0");
  visit("active", r.active,
        "whether it heats from the start; the service set_heat_region "
        "changes it");
  visit("follow_frame", r.follow_frame,
        "tf frame in which position_m and rpy_deg are given and with which the region moves; it "
        "heats nothing until the frame is there; \"\": that of the scene");
}

template <class Visitor>
void describe(Scene& s, Visitor&& visit) {
  visit("name", s.name, "name of the scene");
  visit("description", s.description, "one-sentence description");
  visit("preset", s.preset,
        "set of defaults for all keys that the scene does not set: default, or those of the paper");
  visit("duration_s", s.duration_s, Range{0.0, 1e6}, "simulated time after which run_scene stops");
  visit("gravity_m_s2", s.gravity_m_s2, kGravityRange_m_s2, "gravity");
  visit.section("fluid", s.fluid, "the particles and how their density is measured");
  visit.section("solver", s.solver, "accuracy and run time");
  visit.section("temperature", s.temperature,
                "temperature of the whole scene; with thermal.enabled, of the air");
  visit.section("springs", s.springs, "springs that hold ice together, without thermal.enabled");
  visit.section("thermal", s.thermal,
                "temperature of each particle: conduction, freezing, boiling");
  visit.section("ice", s.ice, "ice, with thermal.enabled");
  visit.section("steam", s.steam, "steam, with thermal.enabled");
  visit.section("bounds", s.bounds,
                "the space of the scene: particles that leave it are removed and counted");
  visit.section("limits", s.limits, "limits");
  visit.list("schedule", s.schedule, "temperature over time");
  visit.list("blocks", s.blocks, "the water");
  visit.list("sources", s.sources, "discs that water flows out of");
  visit.list("drains", s.drains,
             "boxes that remove water and steam, but no ice, at the end of each frame");
  visit.list("heat_regions", s.heat_regions,
             "regions that heat or cool what is in them, with thermal.enabled");
  forEachColliderList(
      s, [&](auto& list, const ColliderKind& kind) { visit.list(kind.key, list, kind.meaning); });
  visit.list("solids", s.solids, "rigid bodies that fall, float and collide");
  visit.list("gauges", s.gauges, "boxes without walls in which the water is measured");
  visit.list("cameras", s.cameras, "cameras: pictures of depth, and of what is where");
}

}  // namespace ice_ice_baby
