// Cameras of a scene as plain data, and their keys, as in params.h.
#pragma once

#include <string>

#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

/// A pinhole camera that sees depth and what is where. It does not affect the water.
struct Camera {
  std::string name;
  Vec3d position_m{1.0, -1.0, 1.0};
  Vec3d look_at_m = Vec3d::Zero();
  std::string follow_frame;
  int width = 640, height = 480;  ///< pixels
  double fov_deg = 60.0;          ///< across the width
  double range_m = 10.0;
  double rate_hz = 10.0;

  /// Pose in the scene frame of its optical frame (REP 103): z looks ahead, x to the right and y
  /// down. Upright, or, looking straight up or down, with x of the scene to the right.
  Posed pose() const;
  /// Focal length in pixels.
  double focalLength() const;
};

/// Largest number of cameras in a scene.
constexpr std::size_t kMaxCameras = 8;

template <class Visitor>
void describe(Camera& c, Visitor&& visit) {
  visit("name", c.name, "name in topics and tf; \"\": camera_0, camera_1, ...");
  visit("position_m", c.position_m, kCoordinateRange_m, "where it stands, without follow_frame");
  visit("look_at_m", c.look_at_m, kCoordinateRange_m,
        "the point in the middle of its picture, without follow_frame");
  visit(
      "follow_frame", c.follow_frame,
      "tf frame that is its optical frame: z ahead, x to the right, y down; \"\": it stands still");
  visit("width", c.width, Range{16, 1920}, "width of its pictures in pixels");
  visit("height", c.height, Range{16, 1200}, "their height");
  visit("fov_deg", c.fov_deg, Range{5.0, 150.0}, "angle across the width");
  visit("range_m", c.range_m, Range{0.01, 1000.0}, "largest depth that it sees");
  visit("rate_hz", c.rate_hz, Range{0.01, 1000.0},
        "pictures per second of wall time; without follow_frame at most one per frame");
}

}  // namespace ice_ice_baby
