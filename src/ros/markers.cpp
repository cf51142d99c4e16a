#include "markers.h"

#include <algorithm>

#include "geometry.h"
#include "ice_ice_baby/collider_mesh.h"
#include "particle_colour.h"

namespace ice_ice_baby {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr Colour kGlass{0.60f, 0.75f, 0.85f};
constexpr Colour kGround{0.55f, 0.55f, 0.55f};
constexpr Colour kObject{0.85f, 0.55f, 0.30f};
constexpr Colour kEdge{0.90f, 0.95f, 1.00f};
constexpr Colour kSpring{0.20f, 0.45f, 0.85f};

Marker deleteAll(const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.action = Marker::DELETEALL;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker makeMarker(const std_msgs::Header& header, const std::string& name, int id, int type,
                  Colour colour, double alpha) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.color.r = colour.red;
  marker.color.g = colour.green;
  marker.color.b = colour.blue;
  marker.color.a = static_cast<float>(alpha);
  return marker;
}

Colour colourOf(Look look) {
  return look == Look::kGlass ? kGlass : look == Look::kGround ? kGround : kObject;
}

/// The surface of a collider: rviz draws an ellipsoid smoother than its triangles.
void fillSurface(const ColliderMesh& mesh, Marker& marker) {
  if (!mesh.half_axes_m.isZero()) {
    marker.type = Marker::SPHERE;
    marker.scale = vectorMessage(2 * mesh.half_axes_m);
    return;
  }
  if (!mesh.resource.empty()) {
    marker.type = Marker::MESH_RESOURCE;
    marker.mesh_resource = mesh.resource;
    marker.scale = vectorMessage(mesh.resource_scale);
    return;
  }
  marker.scale = vectorMessage(Vec3d::Ones());
  for (const auto& corners : mesh.triangles) {
    for (const Index k : corners) marker.points.push_back(pointMessage(mesh.vertices[k]));
  }
}

void fillEdges(const ColliderMesh& mesh, Marker& marker) {
  Eigen::AlignedBox3d bounds;
  for (const auto& edge : mesh.edges) {
    for (const Index k : edge) {
      bounds.extend(mesh.vertices[k]);
      marker.points.push_back(pointMessage(mesh.vertices[k]));
    }
  }
  marker.scale.x = 0.004 * bounds.diagonal().norm();
}

geometry_msgs::Point endMessage(float x, float y, float z) {
  geometry_msgs::Point message;
  message.x = x;
  message.y = y;
  message.z = z;
  return message;
}

}  // namespace

MarkerArray springMarkers(const std::vector<SpringSample>& springs, const std_msgs::Header& header,
                          double width_m, bool clear) {
  MarkerArray array;
  if (clear) array.markers.push_back(deleteAll(header));
  constexpr std::size_t kChunk = kMaxMarkerPoints / 2;
  for (std::size_t first = 0; first < springs.size(); first += kChunk) {
    const std::size_t last = std::min(first + kChunk, springs.size());
    array.markers.push_back(makeMarker(header, "springs", static_cast<int>(first / kChunk),
                                       Marker::LINE_LIST, kSpring, 1.0));
    Marker& marker = array.markers.back();
    marker.scale.x = width_m;
    marker.points.reserve(2 * (last - first));
    for (std::size_t s = first; s < last; ++s) {
      marker.points.push_back(endMessage(springs[s].ax, springs[s].ay, springs[s].az));
      marker.points.push_back(endMessage(springs[s].bx, springs[s].by, springs[s].bz));
    }
  }
  return array;
}

MarkerArray colliderMarkers(const Scene& scene, const std::vector<Posed>& poses,
                            const std_msgs::Header& header) {
  MarkerArray array;
  array.markers.push_back(deleteAll(header));
  auto pose = poses.begin();
  forEachColliderMesh(scene, {}, [&](const Collider& c, const ColliderMesh& mesh) {
    const auto add = [&](int id, int type, Colour colour, double alpha) {
      array.markers.push_back(makeMarker(header, c.name, id, type, colour, alpha));
      array.markers.back().pose = poseMessage(*pose);
      return &array.markers.back();
    };
    if (c.opacity > 0.0) {
      fillSurface(mesh, *add(0, Marker::TRIANGLE_LIST, colourOf(mesh.look), c.opacity));
      if (!mesh.edges.empty()) {
        fillEdges(mesh, *add(1, Marker::LINE_LIST, kEdge, std::min(1.0, 2 * c.opacity)));
      }
    }
    ++pose;
  });
  return array;
}

MarkerArray solidMarkers(const Scene& scene, const std_msgs::Header& header) {
  MarkerArray array;
  forEachSolidMesh(scene, {}, [&](const Solid& solid, const ColliderMesh& mesh) {
    if (solid.opacity == 0.0) return;
    array.markers.push_back(
        makeMarker(header, solid.name, 0, Marker::TRIANGLE_LIST, kSolidColour, solid.opacity));
    fillSurface(mesh, array.markers.back());
  });
  return array;
}

}  // namespace ice_ice_baby
