#include "meshes/solids_of_revolution.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

constexpr double kTolerance_m = 1e-4;

/// Factor on the radius of a polygon that gives it the area of its circle.
double sameArea(int segments) {
  const double angle = 2 * M_PI / segments;
  return std::sqrt(angle / std::sin(angle));
}

}  // namespace

int segmentsOf(double radius_m) {
  return std::clamp(static_cast<int>(M_PI * std::sqrt(radius_m / (2 * kTolerance_m))), 48, 256);
}

TriangleMesh turned(const std::vector<OutlinePoint>& outline, int segments) {
  TriangleMesh mesh;
  const double factor = sameArea(segments);
  const auto around = static_cast<Index>(segments);
  std::vector<Index> first;  // vertex of each point of the outline; a single one on the axis
  for (const OutlinePoint& point : outline) {
    first.push_back(static_cast<Index>(mesh.vertices.size()));
    const Index count = point.radius_m == 0.0 ? 1 : around;
    for (Index k = 0; k < count; ++k) {
      const double angle = 2 * M_PI * k / around;
      const double radius = factor * point.radius_m;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), point.z_m);
    }
  }
  for (std::size_t p = 0; p + 1 < outline.size(); ++p) {
    const bool low_on_axis = outline[p].radius_m == 0.0;
    const bool high_on_axis = outline[p + 1].radius_m == 0.0;
    for (Index k = 0; k < around; ++k) {
      const Index next = (k + 1) % around;
      const Index a = first[p] + (low_on_axis ? 0 : k), b = first[p] + next;
      const Index c = first[p + 1] + (high_on_axis ? 0 : next), d = first[p + 1] + k;
      if (!low_on_axis) mesh.triangles.push_back({a, b, c});
      if (!high_on_axis) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

TriangleMesh cylinderMesh(double radius_m, double height_m) {
  const double half = height_m / 2;
  return turned({{0, -half}, {radius_m, -half}, {radius_m, half}, {0, half}}, segmentsOf(radius_m));
}

TriangleMesh capsuleMesh(double radius_m, double length_m) {
  const int segments = segmentsOf(radius_m), rings = segments / 4;
  std::vector<OutlinePoint> outline;
  for (const double side : {-1.0, 1.0}) {
    for (int k = 0; k <= rings; ++k) {
      const double angle = M_PI / 2 * (side < 0 ? rings - k : k) / rings;
      const bool pole = k == (side < 0 ? 0 : rings);
      outline.push_back({pole ? 0.0 : radius_m * std::cos(angle),
                         side * (length_m / 2 + radius_m * std::sin(angle))});
    }
  }
  return turned(outline, segments);
}

TriangleMesh cupMesh(double inner_radius_m, double depth_m, double wall_m) {
  const double outer = inner_radius_m + wall_m;
  return turned({{0, -wall_m},
                 {outer, -wall_m},
                 {outer, depth_m},
                 {inner_radius_m, depth_m},
                 {inner_radius_m, 0},
                 {0, 0}},
                segmentsOf(outer));
}

}  // namespace ice_ice_baby
