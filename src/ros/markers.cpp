#include "markers.h"

#include <algorithm>

#include "geometry.h"

namespace ice_ice_baby {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Size at which an infinite plane is drawn.
constexpr double kDrawnPlane_m = 20.0;

struct Colour {
  float red, green, blue;
};
constexpr Colour kGlass{0.60f, 0.75f, 0.85f};
constexpr Colour kGround{0.55f, 0.55f, 0.55f};
constexpr Colour kSphere{0.85f, 0.55f, 0.30f};
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

/// Adds the markers of one collider; `low` and `high` are corners in its own frame.
class ColliderPainter {
 public:
  ColliderPainter(const std_msgs::Header& header, const Collider& collider, const Posed& pose,
                  MarkerArray& array)
      : header_(header), collider_(collider), pose_(pose), array_(array) {}

  void box(const Vec3d& low, const Vec3d& high, Colour colour) {
    Marker& marker = add(Marker::CUBE, colour, collider_.opacity);
    marker.pose.position = pointMessage(pose_.toWorld((low + high) / 2));
    marker.scale = vectorMessage(high - low);
  }

  void sphere(double radius_m) {
    Marker& marker = add(Marker::SPHERE, kSphere, collider_.opacity);
    marker.scale = vectorMessage(Vec3d::Constant(2 * radius_m));
  }

  void edges(const Vec3d& low, const Vec3d& high) {
    Marker& marker = add(Marker::LINE_LIST, kEdge, std::min(1.0, 2 * collider_.opacity));
    marker.scale.x = 0.004 * (high - low).norm();
    for (int corner = 0; corner < 8; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        if (corner & (1 << axis)) continue;
        marker.points.push_back(cornerOf(low, high, corner));
        marker.points.push_back(cornerOf(low, high, corner | (1 << axis)));
      }
    }
  }

 private:
  Marker& add(int type, Colour colour, double alpha) {
    Marker marker = makeMarker(header_, collider_.name, next_id_++, type, colour, alpha);
    marker.pose = poseMessage(pose_);
    array_.markers.push_back(marker);
    return array_.markers.back();
  }

  static geometry_msgs::Point cornerOf(const Vec3d& low, const Vec3d& high, int corner) {
    return pointMessage({corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                         corner & 4 ? high.z() : low.z()});
  }

  const std_msgs::Header& header_;
  const Collider& collider_;
  const Posed pose_;
  MarkerArray& array_;
  int next_id_ = 0;
};

void paint(const Container& container, ColliderPainter& painter) {
  const double w = container.wall_m;
  const Vec3d low(-container.size_m.x() / 2, -container.size_m.y() / 2, 0.0);
  const Vec3d high(container.size_m.x() / 2, container.size_m.y() / 2, container.size_m.z());
  painter.box({low.x() - w, low.y() - w, -w}, {high.x() + w, high.y() + w, 0.0}, kGlass);
  painter.box({low.x() - w, low.y() - w, 0.0}, {low.x(), high.y() + w, high.z()}, kGlass);
  painter.box({high.x(), low.y() - w, 0.0}, {high.x() + w, high.y() + w, high.z()}, kGlass);
  painter.box({low.x(), low.y() - w, 0.0}, {high.x(), low.y(), high.z()}, kGlass);
  painter.box({low.x(), high.y(), 0.0}, {high.x(), high.y() + w, high.z()}, kGlass);
  if (!container.open_top) {
    painter.box({low.x() - w, low.y() - w, high.z()}, {high.x() + w, high.y() + w, high.z() + w},
                kGlass);
  }
  painter.edges(low, high);
}

void paint(const Plane& plane, ColliderPainter& painter) {
  const bool infinite = plane.infinite();
  const double x = (infinite ? kDrawnPlane_m : plane.size_x_m) / 2;
  const double y = (infinite ? kDrawnPlane_m : plane.size_y_m) / 2;
  const double depth = infinite ? 0.01 : plane.thickness_m;
  painter.box({-x, -y, -depth}, {x, y, 0.0}, kGround);
}

void paint(const Sphere& sphere, ColliderPainter& painter) { painter.sphere(sphere.radius_m); }

/// @param pose of the first collider @returns that of the collider after the last
template <class Shape>
const Posed* paintAll(const std::vector<Shape>& colliders, const Posed* pose,
                      const std_msgs::Header& header, MarkerArray& array) {
  for (const Shape& collider : colliders) {
    ColliderPainter painter(header, collider, *pose++, array);
    if (collider.opacity > 0.0) paint(collider, painter);
  }
  return pose;
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
  const Posed* pose = poses.data();
  pose = paintAll(scene.containers, pose, header, array);
  pose = paintAll(scene.planes, pose, header, array);
  paintAll(scene.spheres, pose, header, array);
  return array;
}

}  // namespace ice_ice_baby
