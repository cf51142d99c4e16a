// What a vessel or gauge of a scene holds: member, name and meaning.
//
// Vessels are the containers and cups of a scene. A particle belongs to the innermost vessel that
// holds its centre, so water in a cup that stands in a bath counts for the cup only. A gauge counts
// every particle whose centre it holds, whatever vessels and other gauges do.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace ice_ice_baby {

/// Visits the numbers of several records with the same member names, such as the report and its
/// message, as describeReproducible in step_report.h does.
template <class Visitor, class... Records>
void describeVessel(Visitor&& visit, Records&... r) {
  visit("particles", r.particles..., "inside, of any phase");
  visit("water_m3", r.water_m3..., "volume of the water inside");
  visit("ice_m3", r.ice_m3..., "volume of the ice inside");
  visit("level_m", r.level_m...,
        "height that the contents reach at rest, above the lowest point of the inside, against "
        "gravity; NaN without gravity");
  visit("mean_celsius", r.mean_celsius...,
        "degrees Celsius, mean over the particles inside; NaN without heat or particles");
  visit("inflow_m3_s", r.inflow_m3_s..., "what entered, mean over the last 0.5 s");
  visit("outflow_m3_s", r.outflow_m3_s..., "what left, mean over the last 0.5 s");
  visit("entered_m3", r.entered_m3..., "what entered since counting began");
  visit("left_m3", r.left_m3..., "what left since counting began");
}

/// A vessel or gauge after a frame. Volumes of flows are those of the particles as liquid water.
/// The level is that of the contents as liquid water, so floating ice does not change it when it
/// melts; solids in the vessel, and vessels in it, displace water.
struct VesselReport {
  std::string name;
  std::size_t particles = 0;
  double water_m3 = 0.0;
  double ice_m3 = 0.0;
  double level_m = 0.0;
  double mean_celsius = std::numeric_limits<double>::quiet_NaN();
  double inflow_m3_s = 0.0;
  double outflow_m3_s = 0.0;
  double entered_m3 = 0.0;
  double left_m3 = 0.0;
};

}  // namespace ice_ice_baby
