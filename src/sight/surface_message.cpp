#include "surface_message.h"

#include "particle_colour.h"

namespace ice_ice_baby {

namespace {

using visualization_msgs::Marker;

constexpr float kWaterAlpha = 0.6f;

geometry_msgs::Point32 pointOf(float x, float y, float z) {
  geometry_msgs::Point32 point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

std::vector<geometry_msgs::Point32> pointsOf(const std::vector<Vec3<float>>& vectors) {
  std::vector<geometry_msgs::Point32> points;
  points.reserve(vectors.size());
  for (const Vec3<float>& v : vectors) points.push_back(pointOf(v.x(), v.y(), v.z()));
  return points;
}

SurfaceMesh meshMessage(const FluidSurface& surface) {
  SurfaceMesh mesh;
  mesh.vertices = pointsOf(surface.vertices);
  mesh.normals = pointsOf(surface.normals);
  mesh.velocities = pointsOf(surface.velocities);
  mesh.temperatures = surface.temperatures_c;
  mesh.ice_fractions = surface.ice_fractions;
  mesh.triangles.resize(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) mesh.triangles[t].vertices[k] = surface.triangles[t][k];
  }
  return mesh;
}

std_msgs::ColorRGBA colourOf(std::uint32_t packed, float alpha) {
  const Colour parts = unpacked(packed);
  std_msgs::ColorRGBA colour;
  colour.r = parts.red;
  colour.g = parts.green;
  colour.b = parts.blue;
  colour.a = alpha;
  return colour;
}

Marker markerOf(const Surface& surface, const SurfaceMesh& mesh, Phase phase) {
  Marker marker;
  marker.header = surface.header;
  marker.ns = choices(phase)[static_cast<std::size_t>(phase)];
  marker.pose.orientation.w = 1.0;
  marker.action = mesh.triangles.empty() ? Marker::DELETE : Marker::ADD;
  if (mesh.triangles.empty()) return marker;
  marker.type = Marker::TRIANGLE_LIST;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = phase == Phase::kWater ? kWaterAlpha : 1.0f;
  marker.points.reserve(3 * mesh.triangles.size());
  marker.colors.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle.vertices) {
      geometry_msgs::Point point;
      point.x = mesh.vertices[v].x;
      point.y = mesh.vertices[v].y;
      point.z = mesh.vertices[v].z;
      marker.points.push_back(point);
      const std::uint32_t colour =
          surfaceColour(phase, surface.thermal, mesh.temperatures[v], mesh.ice_fractions[v]);
      marker.colors.push_back(colourOf(colour, marker.color.a));
    }
  }
  return marker;
}

}  // namespace

Surface surfaceMessage(const std::vector<ParticleSample>& particles, double spacing_m) {
  Surface surface;
  surface.spacing_m = static_cast<float>(spacing_m);
  surface.water = meshMessage(surfaceOf(particles, Phase::kWater, spacing_m));
  surface.ice = meshMessage(surfaceOf(particles, Phase::kIce, spacing_m));
  for (const ParticleSample& p : particles) {
    if (p.phase == Phase::kSteam) surface.steam.push_back(pointOf(p.x, p.y, p.z));
  }
  return surface;
}

visualization_msgs::MarkerArray surfaceMarkers(const Surface& surface) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(markerOf(surface, surface.ice, Phase::kIce));
  array.markers.push_back(markerOf(surface, surface.water, Phase::kWater));
  return array;
}

}  // namespace ice_ice_baby
