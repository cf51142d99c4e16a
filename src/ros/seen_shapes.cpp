#include "seen_shapes.h"

#include "ice_ice_baby/collider_mesh.h"
#include "ice_ice_baby/each_collider.h"

namespace ice_ice_baby {

namespace {

/// Round shapes are rounder than a pixel shows, and grounds go on for a kilometre.
MeshDetail detail() {
  MeshDetail detail;
  detail.round_segments = 128;
  detail.ground_size_m = 2000.0;
  return detail;
}

bool isSeen(Look look, double opacity) {
  return look == Look::kGlass ? opacity >= 0.5 : opacity > 0.0;
}

}  // namespace

SeenShapes::SeenShapes(const Scene& scene) {
  const auto shapeOf = [](const ColliderMesh& mesh) {
    Shape shape;
    shape.triangles = mesh.triangles;
    for (const Vec3d& v : mesh.vertices) shape.vertices.push_back(v.cast<float>());
    return shape;
  };
  forEachColliderMesh(scene, detail(), [&](const Collider& c, const ColliderMesh& mesh) {
    colliders_.push_back(isSeen(mesh.look, c.opacity) ? shapeOf(mesh) : Shape());
  });
  forEachSolidMesh(scene, detail(), [&](const Solid& solid, const ColliderMesh& mesh) {
    if (solid.opacity > 0.0) solids_.emplace_back(solid.name, shapeOf(mesh));
  });
}

SeenShapes::Places SeenShapes::places(const Simulation& simulation) {
  Places places;
  forEachCollider(simulation.scene(), [&](const Collider& collider) {
    places.colliders.push_back(simulation.colliderPose(collider.name));
  });
  places.solids = simulation.solids();
  return places;
}

void SeenShapes::add(RayScene& rays, const Shape& shape, const Posed& pose) {
  std::vector<Vec3<float>> vertices;
  vertices.reserve(shape.vertices.size());
  const Pose<float> placed = pose.cast<float>();
  for (const Vec3<float>& v : shape.vertices) vertices.push_back(placed.toWorld(v));
  rays.add(vertices, shape.triangles, Seen::kSolid);
}

void SeenShapes::addTo(RayScene& rays, const Places& places) const {
  for (std::size_t k = 0; k < colliders_.size(); ++k) add(rays, colliders_[k], places.colliders[k]);
  for (const auto& [name, shape] : solids_) {
    for (const SolidState& solid : places.solids) {
      if (solid.name == name) add(rays, shape, solid.pose);
    }
  }
}

}  // namespace ice_ice_baby
