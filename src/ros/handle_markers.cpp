#include "handle_markers.h"

#include <algorithm>
#include <map>

#include "geometry.h"
#include "ice_ice_baby/collider_mesh.h"

namespace ice_ice_baby {

namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

/// rviz draws handles smaller than this badly, m.
constexpr double kSmallest_m = 0.05;

/// Diameter of each collider about its origin, m; none for infinite ones.
std::map<std::string, double> colliderSizes_m(const Scene& scene) {
  std::map<std::string, double> sizes_m;
  forEachColliderMesh(scene, {}, [&](const Collider& collider, const ColliderMesh& mesh) {
    if (mesh.infinite) return;
    double reach_m = mesh.half_axes_m.maxCoeff();
    for (const Vec3d& vertex : mesh.vertices) reach_m = std::max(reach_m, vertex.norm());
    sizes_m[collider.name] = 2 * reach_m;
  });
  return sizes_m;
}

/// An arrow along an axis and a ring about it. rviz takes the x axis of the orientation for both.
void addControls(InteractiveMarker& marker, const std::string& name, const Vec3d& axis) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3d::UnitX(), axis);
  InteractiveMarkerControl control;
  control.orientation = quaternionMessage(turn.toRotationMatrix());
  control.name = "move_" + name;
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  marker.controls.push_back(control);
  control.name = "rotate_" + name;
  control.interaction_mode = InteractiveMarkerControl::ROTATE_AXIS;
  marker.controls.push_back(control);
}

InteractiveMarker makeMarker(const Steered& what, const std::string& frame, double size_m) {
  InteractiveMarker marker;
  marker.header.frame_id = frame;
  marker.name = marker.description = what.words();
  marker.scale = static_cast<float>(std::max(1.2 * size_m, kSmallest_m));
  marker.pose = poseMessage(what.pose);
  addControls(marker, "x", Vec3d::UnitX());
  addControls(marker, "y", Vec3d::UnitY());
  addControls(marker, "z", Vec3d::UnitZ());
  return marker;
}

void show(InteractiveMarker& marker, int type, const Vec3d& size_m, const Vec3d& colour) {
  Marker shape;
  shape.type = type;
  shape.scale = vectorMessage(size_m);
  shape.pose.orientation.w = 1.0;
  shape.color.r = static_cast<float>(colour.x());
  shape.color.g = static_cast<float>(colour.y());
  shape.color.b = static_cast<float>(colour.z());
  shape.color.a = 0.4f;
  InteractiveMarkerControl control;
  control.name = "shape";
  control.orientation.w = 1.0;
  control.always_visible = true;
  control.markers.push_back(shape);
  marker.controls.push_back(control);
}

InteractiveMarker markerOf(const Source& source, const Steered& what, const std::string& frame) {
  InteractiveMarker marker = makeMarker(what, frame, 6 * source.radius_m);
  const double width_m = 2 * source.radius_m;
  show(marker, Marker::CYLINDER, {width_m, width_m, width_m / 4}, {0.2, 0.5, 0.9});
  return marker;
}

InteractiveMarker markerOf(const HeatRegionParams& region, const Steered& what,
                           const std::string& frame) {
  InteractiveMarker marker = makeMarker(what, frame, region.size_m.maxCoeff());
  const bool box = region.shape == BlockShape::kBox;
  const Vec3d hot(1.0, 0.45, 0.1), cold(0.6, 0.85, 1.0);
  show(marker, box ? Marker::CUBE : Marker::SPHERE, region.size_m,
       region.power_w > 0.0 ? hot : cold);
  return marker;
}

}  // namespace

std::vector<Handle> everyHandle(const Scene& scene, const std::string& scene_frame) {
  const std::map<std::string, double> sizes_m = colliderSizes_m(scene);
  std::vector<Handle> handles;
  auto source = scene.sources.begin();
  auto region = scene.heat_regions.begin();
  for (const Steered& what : everySteered(scene)) {
    InteractiveMarker marker;
    if (what.kind == SteeredKind::kSource) {
      marker = markerOf(*source++, what, scene_frame);
    } else if (what.kind == SteeredKind::kHeatRegion) {
      marker = markerOf(*region++, what, scene_frame);
    } else if (sizes_m.count(what.name) > 0) {
      marker = makeMarker(what, scene_frame, sizes_m.at(what.name));
    } else {
      continue;
    }
    if (what.follow_frame.empty()) handles.push_back({what, marker});
  }
  return handles;
}

}  // namespace ice_ice_baby
