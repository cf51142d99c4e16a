// Sources and drains of a scene as plain data, and their keys, as in params.h.
#pragma once

#include <cmath>
#include <string>

#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

/// Litres per minute of one cubic metre per second.
constexpr double kLitresPerMinute = 60000.0;

constexpr Range kFlowRange_l_min{0.0, 1e12};

/// Water that comes out of a disc, with the velocity of the flow.
struct Source {
  std::string name;
  Vec3d position_m = Vec3d::Zero();  ///< centre of the disc
  Vec3d direction{0.0, 0.0, -1.0};   ///< normal of the disc, along the flow; of any length but 0
  std::string follow_frame;
  double radius_m = 0.02;
  double speed_m_s = 0.0;   ///< 0: follows from the flow
  double flow_l_min = 0.0;  ///< 0: follows from the speed
  double temperature_c = 20.0;
  bool open = true;

  /// Pose of the disc in the scene frame, or in `follow_frame`: z is the direction of the flow.
  Posed pose() const;
  double area_m2() const { return M_PI * radius_m * radius_m; }
  /// Flow and speed in force. One of them is given, the other is flow = speed x area.
  double flowInForce_m3_s() const {
    return flow_l_min > 0.0 ? flow_l_min / kLitresPerMinute : speed_m_s * area_m2();
  }
  double speedInForce_m_s() const {
    return flow_l_min > 0.0 ? flow_l_min / kLitresPerMinute / area_m2() : speed_m_s;
  }
};

template <class Visitor>
void describe(Source& s, Visitor&& visit) {
  visit("name", s.name, "name used by services; \"\": source_0, source_1, ...");
  visit("position_m", s.position_m, kCoordinateRange_m, "centre of the disc that water leaves");
  visit("direction", s.direction, Range{-1e6, 1e6}, "direction of the flow; any length but 0");
  visit("follow_frame", s.follow_frame,
        "tf frame in which position_m and direction are given and with which the disc moves; it is "
        "closed until the frame is there; \"\": that of the scene");
  visit("radius_m", s.radius_m, Range{1e-5, kMaxCoordinate_m}, "radius of the disc");
  visit("speed_m_s", s.speed_m_s, Range{0.0, 1e5},
        "speed of the water; 0: follows from flow_l_min, one of the two must be given");
  visit("flow_l_min", s.flow_l_min, kFlowRange_l_min,
        "flow in litres per minute, each particle the cube of fluid.spacing_m; 0: follows from "
        "speed_m_s");
  visit("temperature_c", s.temperature_c, kTemperatureRange_c,
        "temperature of the water, with thermal.enabled; from thermal.freezing_c to "
        "thermal.boiling_c");
  visit("open", s.open, "whether water flows from the start; the service set_source changes it");
}

/// A box that takes water away.
struct Drain {
  std::string name;
  Vec3d min_m = Vec3d::Zero();
  Vec3d max_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  double rate_l_min = 0.0;  ///< 0: unlimited

  Vec3d centre_m() const { return (min_m + max_m) / 2; }
};

template <class Visitor>
void describe(Drain& d, Visitor&& visit) {
  visit("name", d.name, "name in messages; \"\": drain_0, drain_1, ...");
  visit("min_m", d.min_m, kCoordinateRange_m, "lower corner");
  visit("max_m", d.max_m, kCoordinateRange_m, "upper corner");
  visit("rpy_deg", d.rpy_deg, Range{-360.0, 360.0}, "roll, pitch, yaw of the box about its centre");
  visit("rate_l_min", d.rate_l_min, kFlowRange_l_min,
        "maximum flow in litres per minute; 0: removes all water that enters");
}

}  // namespace ice_ice_baby
