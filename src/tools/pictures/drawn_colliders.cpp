#include "pictures/drawn_colliders.h"

#include <algorithm>

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

/// A plate without end shows as far as the scene goes.
Eigen::Vector3f halfSize(const Scene& scene, const Plane& plane) {
  if (!plane.infinite()) {
    return 0.5f *
           Eigen::Vector3f(float(plane.size_x_m), float(plane.size_y_m), float(plane.thickness_m));
  }
  const Eigen::Vector3f sizes = boundsOf(scene).sizes();
  const float half = 0.8f * std::max(sizes.x(), sizes.y());
  return {half, half, 0.04f * half};
}

/// Sides of a box that face the eye.
void drawBox(const Pose<float>& pose, const Eigen::Vector3f& centre, const Eigen::Vector3f& half,
             Colour colour, float opacity, Canvas& canvas) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const Eigen::Vector3f out = side * Eigen::Vector3f::Unit(axis);
      const auto corner = [&](float u, float v) {
        Eigen::Vector3f at = side * half;
        at[(axis + 1) % 3] = u * half[(axis + 1) % 3];
        at[(axis + 2) % 3] = v * half[(axis + 2) % 3];
        return pose.toWorld(centre + at);
      };
      const Eigen::Vector3f normal = pose.toWorld(centre + out) - pose.toWorld(centre);
      if (normal.dot(canvas.eye() - corner(1, 1)) <= 0) continue;
      const Colour lit = dimmed(colour, 0.8f + 0.2f * normal.dot(Eigen::Vector3f(-0.5f, -0.1f, 1)));
      canvas.drawTriangle(corner(-1, -1), corner(1, -1), corner(1, 1), lit, opacity);
      canvas.drawTriangle(corner(-1, -1), corner(1, 1), corner(-1, 1), lit, opacity);
    }
  }
}

void drawPlates(const Simulation& simulation, bool opaque, Canvas& canvas) {
  for (const Plane& plane : simulation.scene().planes) {
    if ((plane.opacity >= 1.0) != opaque || plane.opacity == 0.0) continue;
    const Eigen::Vector3f half = halfSize(simulation.scene(), plane);
    drawBox(simulation.colliderPose(plane.name).cast<float>(), {0, 0, -half.z()}, half,
            colourOf(plane, kPlain), float(plane.opacity), canvas);
  }
}

void drawEdges(const Container& c, const Pose<float>& pose, Canvas& canvas) {
  for (int k = 0; k < 8; ++k) {
    for (const int axis : {1, 2, 4}) {
      if (k & axis) continue;
      canvas.drawLine(pose.toWorld(boxCorner(c, k)), pose.toWorld(boxCorner(c, k | axis)),
                      mixed(colourOf(c, kPlain), {1, 1, 1}, 0.3f), 0.5f, 2);
    }
  }
}

Eigen::AlignedBox3f boundsOfColliders(const Scene& scene) {
  Eigen::AlignedBox3f bounds;
  for (const Container& c : scene.containers) {
    const Pose<float> pose = c.pose().cast<float>();
    for (int k = 0; k < 8; ++k) bounds.extend(pose.toWorld(boxCorner(c, k)));
  }
  for (const Sphere& s : scene.spheres) {
    const Eigen::Vector3f r = Eigen::Vector3f::Constant(float(s.radius_m));
    bounds.extend(s.position_m.cast<float>() - r).extend(s.position_m.cast<float>() + r);
  }
  return bounds;
}

}  // namespace

Eigen::Vector3f boxCorner(const Container& container, int k) {
  const Eigen::Vector3f size = container.size_m.cast<float>();
  const Eigen::Vector3f half(size.x() / 2, size.y() / 2, size.z());
  return {k & 1 ? half.x() : -half.x(), k & 2 ? half.y() : -half.y(), k & 4 ? half.z() : 0.0f};
}

Eigen::AlignedBox3f boundsOf(const Scene& scene) {
  Eigen::AlignedBox3f bounds = boundsOfColliders(scene);
  for (const Block& block : scene.blocks) {
    bounds.extend(block.min_m.cast<float>()).extend(block.max_m.cast<float>());
  }
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector3f::Zero()).extend(Eigen::Vector3f::Ones());
  return bounds;
}

Eigen::AlignedBox3f stageOf(const Scene& scene) {
  if (scene.containers.empty()) return boundsOf(scene);
  Eigen::AlignedBox3f bounds = boundsOfColliders(scene);
  for (const Plane& plane : scene.planes) {
    if (plane.infinite()) continue;
    const Eigen::Vector3f half = halfSize(scene, plane);
    const Pose<float> pose = plane.pose().cast<float>();
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3f side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 0 : -2);
      bounds.extend(pose.toWorld(half.cwiseProduct(side)));
    }
  }
  return bounds;
}

void drawOpaqueColliders(const Simulation& simulation, Canvas& canvas) {
  for (const Sphere& s : simulation.scene().spheres) {
    canvas.drawSphere(simulation.colliderPose(s.name).position.cast<float>(), float(s.radius_m),
                      colourOf(s, kBrass));
  }
  drawPlates(simulation, true, canvas);
}

void drawClearColliders(const Simulation& simulation, Canvas& canvas) {
  for (const Container& c : simulation.scene().containers) {
    const Pose<float> pose = simulation.colliderPose(c.name).cast<float>();
    const Eigen::Vector3f half(float(c.size_m.x()) / 2, float(c.size_m.y()) / 2, 0.0f);
    if (c.heat != ThermalBoundary::kInsulated) {
      drawBox(pose, Eigen::Vector3f::Zero(), half, colourOf(c, kPlain), 0.6f, canvas);
    }
    drawEdges(c, pose, canvas);
  }
  drawPlates(simulation, false, canvas);
}

}  // namespace ice_ice_baby
