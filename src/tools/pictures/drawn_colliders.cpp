#include "pictures/drawn_colliders.h"

#include <algorithm>

#include "ice_ice_baby/collider_mesh.h"
#include "stage.h"

namespace ice_ice_baby {

namespace {

constexpr Colour kPlain{0.52f, 0.55f, 0.58f};
constexpr Colour kCold{0.25f, 0.55f, 1.0f};
constexpr Colour kHot{1.0f, 0.42f, 0.12f};
constexpr Colour kBrass{0.75f, 0.45f, 0.3f};

Colour colourOf(const Collider& c, Colour plain) {
  if (c.heat == ThermalBoundary::kInsulated) return plain;
  const bool hot = c.heat == ThermalBoundary::kFlux ? c.flux_w_m2 > 0 : c.celsius > 20;
  const double strength = c.heat == ThermalBoundary::kFlux ? 1.0
                          : hot                            ? 0.4 + c.celsius / 200
                                                           : 0.4 - c.celsius / 60;
  return mixed(kPlain, hot ? kHot : kCold, float(strength));
}

Colour dimmed(Colour c, float light) { return {c.red * light, c.green * light, c.blue * light}; }

using Visit = std::function<void(const Collider&, const ColliderMesh&)>;

/// A ground without end shows as far as the scene goes.
void forEachDrawn(const Scene& scene, const Visit& visit) {
  const Eigen::Vector3f sizes = boundsOf(scene).sizes();
  MeshDetail detail;
  detail.ground_size_m = 1.6 * double(std::max(sizes.x(), sizes.y()));
  detail.ground_depth_m = 0.04 * detail.ground_size_m;
  detail.round_segments = 64;
  forEachColliderMesh(scene, detail, visit);
}

Pose<float> poseNow(const Simulation& simulation, const Collider& collider) {
  return simulation.colliderPose(collider.name).cast<float>();
}

/// Triangles that face the eye. @param floor_only those that face up at the height of the origin
void drawTriangles(const ColliderMesh& mesh, const Pose<float>& pose, Colour colour, float opacity,
                   bool floor_only, Canvas& canvas) {
  for (const auto& corners : mesh.triangles) {
    const Vec3d &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]],
                &c = mesh.vertices[corners[2]];
    const Vec3d up = (b - a).cross(c - a).normalized();
    if (floor_only && (up.z() < 0.9 || std::max({a.z(), b.z(), c.z()}) > 0)) continue;
    const Eigen::Vector3f normal = pose.rotation * up.cast<float>();
    const Eigen::Vector3f at = pose.toWorld(a.cast<float>());
    if (normal.dot(canvas.eye() - at) <= 0) continue;
    const Colour lit = dimmed(colour, 0.8f + 0.2f * normal.dot(Eigen::Vector3f(-0.5f, -0.1f, 1)));
    canvas.drawTriangle(at, pose.toWorld(b.cast<float>()), pose.toWorld(c.cast<float>()), lit,
                        opacity);
  }
}

void drawSolid(const ColliderMesh& mesh, const Pose<float>& pose, Colour colour, float opacity,
               Canvas& canvas) {
  const double radius_m = mesh.half_axes_m.x();
  if (radius_m > 0 && mesh.half_axes_m == Vec3d::Constant(radius_m)) {
    canvas.drawSphere(pose.position, float(radius_m), colour);
  } else {
    drawTriangles(mesh, pose, colour, opacity, false, canvas);
  }
}

void drawEdges(const ColliderMesh& mesh, const Pose<float>& pose, Colour colour, float opacity,
               int wide, Canvas& canvas) {
  for (const auto& [a, b] : mesh.edges) {
    canvas.drawLine(pose.toWorld(mesh.vertices[a].cast<float>()),
                    pose.toWorld(mesh.vertices[b].cast<float>()), colour, opacity, wide);
  }
}

}  // namespace

void drawOpaqueColliders(const Simulation& simulation, Canvas& canvas) {
  forEachDrawn(simulation.scene(), [&](const Collider& c, const ColliderMesh& mesh) {
    const bool object = mesh.look == Look::kObject;
    if (!object && (mesh.look != Look::kGround || c.opacity < 1.0)) return;
    drawSolid(mesh, poseNow(simulation, c), colourOf(c, object ? kBrass : kPlain), 1.0f, canvas);
  });
}

void drawClearColliders(const Simulation& simulation, Canvas& canvas) {
  forEachDrawn(simulation.scene(), [&](const Collider& c, const ColliderMesh& mesh) {
    const Pose<float> pose = poseNow(simulation, c);
    const Colour colour = colourOf(c, kPlain);
    if (mesh.look == Look::kGround && c.opacity > 0.0 && c.opacity < 1.0) {
      drawSolid(mesh, pose, colour, float(c.opacity), canvas);
    }
    if (mesh.look != Look::kGlass) return;
    if (c.heat != ThermalBoundary::kInsulated) {
      drawTriangles(mesh, pose, colour, 0.6f, true, canvas);
    }
    drawEdges(mesh, pose, mixed(colour, {1, 1, 1}, 0.3f), 0.5f, 2, canvas);
  });
}

void drawSolids(const Simulation& simulation, Canvas& canvas) {
  MeshDetail detail;
  detail.round_segments = 64;
  const std::vector<SolidState> states = simulation.solids();
  forEachSolidMesh(simulation.scene(), detail, [&](const Solid& solid, const ColliderMesh& mesh) {
    for (const SolidState& state : states) {
      if (state.name != solid.name) continue;
      drawSolid(mesh, state.pose.cast<float>(), kSolidColour, 1.0f, canvas);
    }
  });
}

void drawPlainColliders(const Simulation& simulation, Canvas& canvas) {
  forEachDrawn(simulation.scene(), [&](const Collider& c, const ColliderMesh& mesh) {
    const Pose<float> pose = poseNow(simulation, c);
    if (mesh.look == Look::kObject) drawSolid(mesh, pose, kBrass, 1.0f, canvas);
    if (mesh.look == Look::kGlass) drawEdges(mesh, pose, {0.35f, 0.38f, 0.42f}, 0.8f, 1, canvas);
  });
}

}  // namespace ice_ice_baby
